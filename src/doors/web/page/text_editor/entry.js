// What the workbench takes of CodeMirror and of qrcode-generator (MIT).
/*! CodeMirror 6 (@codemirror, @lezer, style-mod, w3c-keyname, crelt, @marijn/find-cluster-break)
 * Copyright (C) 2016-2024 by Marijn Haverbeke <marijn@haverbeke.berlin> and others. MIT License:
 *
 * Permission is hereby granted, free of charge, to any person obtaining a copy
 * of this software and associated documentation files (the "Software"), to deal
 * in the Software without restriction, including without limitation the rights
 * to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
 * copies of the Software, and to permit persons to whom the Software is
 * furnished to do so, subject to the following conditions:
 *
 * The above copyright notice and this permission notice shall be included in
 * all copies or substantial portions of the Software.
 *
 * THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
 * IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
 * FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
 * AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
 * LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
 * OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN
 * THE SOFTWARE.
 *
 * qrcode-generator, Copyright (c) 2009 Kazuhiko Arase, http://www.d-project.com/. The same licence. The word "QR Code" is a registered
 * trademark of DENSO WAVE INCORPORATED.
 */
import {autocompletion, closeBrackets, closeBracketsKeymap, completionKeymap, startCompletion} from '@codemirror/autocomplete';
import {defaultKeymap, history, historyField, historyKeymap, isolateHistory} from '@codemirror/commands';
import {bracketMatching, codeFolding, foldGutter, foldKeymap, foldService, StreamLanguage, syntaxHighlighting} from '@codemirror/language';
import {toml} from '@codemirror/legacy-modes/mode/toml';
import {lintGutter, setDiagnostics} from '@codemirror/lint';
import {highlightSelectionMatches, search, searchKeymap} from '@codemirror/search';
import {EditorState, Transaction} from '@codemirror/state';
import {drawSelection, EditorView, highlightActiveLine, highlightActiveLineGutter, hoverTooltip, keymap, lineNumbers} from '@codemirror/view';
import {classHighlighter} from '@lezer/highlight';
import qrcode from 'qrcode-generator';
import {StyleModule} from 'style-mod';

// The page's policy allows no style elements of scripts; sheets that a script makes need no permission.
const mounted = new Set();
StyleModule.mount = (root, modules) => {
  const fresh = [modules].flat().filter((module) => !mounted.has(module));
  const sheets = fresh.map((module) => {
    mounted.add(module);
    const sheet = new CSSStyleSheet();
    sheet.replaceSync(module.getRules());
    return sheet;
  });
  // Later modules take precedence.
  document.adoptedStyleSheets = [...document.adoptedStyleSheets, ...sheets];
};

globalThis.text_editor = {autocompletion, bracketMatching, classHighlighter, closeBrackets, closeBracketsKeymap, codeFolding, completionKeymap, defaultKeymap,
  drawSelection, EditorState, EditorView, foldGutter, foldKeymap, foldService, highlightActiveLine, highlightActiveLineGutter, highlightSelectionMatches,
  history, historyField, historyKeymap, hoverTooltip, isolateHistory, keymap, lineNumbers, lintGutter, qrcode, search, searchKeymap, setDiagnostics, startCompletion,
  StreamLanguage, syntaxHighlighting, toml, Transaction};
