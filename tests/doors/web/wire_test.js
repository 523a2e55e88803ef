// The answers of the module have the types that program.js declares: every field of an answer is declared, every declared field is there,
// and of every field both the kinds that are declared and the kinds that occur are the same.
// Usage: node wire_test.js POINSOT MODULE FONTS PROGRAM_JS SCENES_FOLDER
'use strict';
const test = require('node:test');
const assert = require('node:assert/strict');
const fs = require('node:fs');
const path = require('node:path');
const ts = require('typescript');
const {files_of} = require('./scene_files.js');

const [, module_file, fonts_file, program_file, folder] = process.argv.slice(2);
const started = import(path.resolve(program_file)).then(({Program}) => Program.start(fs.readFileSync(module_file), fs.readFileSync(fonts_file), null));

const config_file = path.join(__dirname, 'tsconfig.json');
const config = ts.parseJsonConfigFileContent(ts.readConfigFile(config_file, ts.sys.readFile).config, ts.sys, __dirname);
const sources = ts.createProgram(config.fileNames, config.options);
const checker = sources.getTypeChecker();

/** The type of this name in a script of the page. @param {string} name @param {string} script */
function type_named(name, script) {
  const file = sources.getSourceFiles().find((source) => path.basename(source.fileName) === script && source.fileName.includes('/web/page/'));
  assert.ok(file, `${script} is among the scripts`);
  const symbol = checker.getExportsOfModule(checker.getSymbolAtLocation(file)).find((alias) => alias.name === name);
  assert.ok(symbol, `${script} has the type ${name}`);
  return checker.getDeclaredTypeOfSymbol(symbol);
}

const members_of = (type) => (type.isUnion() ? type.types : [type]);

/** The kinds of a type's values: "string", "null", "list" …, a text with its own kind; undefined: a field may be absent. */
const declared_kinds = (type) => new Set(members_of(type).map((member) => {
  if (checker.isArrayType(member)) return 'list';
  if (member.isStringLiteral()) return `"${member.value}"`;
  const flags = [[ts.TypeFlags.StringLike, 'string'], [ts.TypeFlags.NumberLike, 'number'], [ts.TypeFlags.BooleanLike, 'boolean'], [ts.TypeFlags.Null, 'null'],
    [ts.TypeFlags.Undefined, 'undefined'], [ts.TypeFlags.Object, 'object']];
  const kind = flags.find(([flag]) => member.flags & flag);
  assert.ok(kind, `a type that no answer can have: ${checker.typeToString(member)}`);
  return kind[1];
}));

const kind_of = (value, declared) => {
  if (value === undefined) return 'undefined';
  if (value === null) return 'null';
  if (Array.isArray(value)) return 'list';
  // A text is a kind of its own where the type lists texts.
  return typeof value === 'string' && [...declared].some((kind) => kind.startsWith('"')) ? `"${value}"` : typeof value;
};

/** The kinds that occurred, by place: "Loaded.stops[].loop_s". @type {Map<string, {declared: Set<string>, seen: Set<string>}>} */
const places = new Map();

/** Compares a value with its type, and notes what it is. */
function compare(value, type, place) {
  const declared = declared_kinds(type);
  const kind = kind_of(value, declared);
  assert.ok(declared.has(kind), `${place} is ${kind}, declared as ${checker.typeToString(type)}`);
  if (!places.has(place)) places.set(place, {declared, seen: new Set()});
  places.get(place).seen.add(kind);
  const member = members_of(type).find((each) => (kind === 'list' ? checker.isArrayType(each) : kind === 'object' && each.flags & ts.TypeFlags.Object && !checker.isArrayType(each)));
  if (kind === 'list') for (const item of value) compare(item, checker.getTypeArguments(member)[0], `${place}[]`);
  if (kind !== 'object') return;
  const fields = new Map(checker.getPropertiesOfType(member).map((field) => [field.name, checker.getTypeOfSymbol(field)]));
  for (const name of Object.keys(value)) assert.ok(fields.has(name), `${place}.${name} is not declared`);
  for (const [name, field] of fields) compare(value[name], field, `${place}.${name}`);
}

const free = '[body]\nmoments_kg_m2 = [3, 2, 1.5]\n[start]\nomega_rad_s = [0.1, 1, 0.3]\n';
// What no scene of the folder has.
const more = {
  controls: `${free}[motion]\nmethod = "splitting"\norder = 2\n[page]\ncontrols = ["start.omega_rad_s", "film.speed", "construction.plane", "labels", "motion.order"]\n`,
  offered: `${free}[page]\nelements = ["plane"]\n`,
  stop: `${free}[film]\nduration_s = 9\n[[stops]]\nat_s = 3\nloop_s = 1\nplanned_s = 60\nnote = "n"\n[[stops]]\nat_s = 5\n[[chapters]]\nat_s = 4\ntitle = "c"\n`,
  slowed: `${free}[torque]\nkind = "dissipation"\nhalf_life_s = 100\n[motion]\nmethod = "dopri5"\n`,
  separatrix: '[body]\nmoments_kg_m2 = [3, 2, 1]\n[start]\nenergy_J = 1\nmomentum_kg_m2_s = 2\n',
};

test('the answers of the module have the declared types', async () => {
  const program = await started;
  const loaded = type_named('Loaded', 'program.js');
  const names = ['generic', 'heavy_top_looping', 'lecture', 'measured', 'tennis_racket'].map((name) => `${name}.toml`);
  const scenes = [...names.map((name) => [name, fs.readFileSync(path.join(folder, name), 'utf8')]), ...Object.entries(more)];
  for (const [name, text] of scenes) {
    for (const named of files_of(text)) program.addFile(named, fs.readFileSync(path.join(folder, named)));
    compare(program.load(text, name, [], {width: 640, height: 360}), loaded, 'Loaded');
    for (const panel of program.resize(320, 480)) compare(panel, type_named('Panel', 'program.js'), 'Panel');
    for (const grip of program.grips(0)) compare(grip, type_named('Grip', 'grips.js'), 'Grip');
    compare(program.at(0), type_named('Digits', 'program.js'), 'Digits');
  }
  program.openFilm(more.stop, 'stop', ['film.size=64x36']);
  compare(program.openFilm(more.stop, 'stop', ['film.size=64x36']), type_named('FilmDescription', 'make_film.js'), 'FilmDescription');
  compare(program.openFilm(`theme = "transparent"\n${free}`, 'free', ['film.size=64x36']), type_named('FilmDescription', 'make_film.js'), 'FilmDescription');
  program.openFilm(more.stop, 'stop', ['film.size=64x36']);
  compare(program.filmTexts([0, 100], 'stop.mp4'), type_named('FilmTexts', 'film_file.js'), 'FilmTexts');
  assert.ok(places.size > 80, `${places.size} places`);
  const never = [...places].flatMap(([place, {declared, seen}]) => [...declared].filter((kind) => !seen.has(kind)).map((kind) => `${place} is never ${kind}`));
  assert.deepEqual(never, []);
});

// However the scene is written: the energy with the momentum sets the plane, the energy with a distance does not.
test('what can be dragged follows from the scene', async () => {
  const program = await started;
  const drags = (start, control) => program.load(`start = {${start}, omega_rad_s = [0.1, 1, 0.3]}\n[body]\nmoments_kg_m2 = [3, 2, 1.5]\n`
    + `[page]\ncontrols = ["${control}"]\n`, 'drags', [], {width: 640, height: 360}).drags;
  assert.deepEqual(drags('energy_J = 1.0, momentum_kg_m2_s = 2.0', 'start.energy_J'), {omega: false, plane: true});
  assert.deepEqual(drags('energy_J = 1.0, plane_distance = 0.7', 'start.energy_J'), {omega: false, plane: false});
  assert.deepEqual(program.load(free, 'free', [], {width: 640, height: 360}).drags, {omega: true, plane: true});
});

test('a view has the values that the module takes', async () => {
  const program = await started;
  const declared = checker.getPropertiesOfType(type_named('View', 'program.js')).map((field) => field.name);
  assert.deepEqual([...program.view_names, 'panel'].sort(), declared.sort());
  // Links have them, too, in an order of their own that may not change.
  const {view_keys} = await import('../../../src/doors/web/page/link.js');
  assert.deepEqual([...program.view_names].sort(), [...view_keys].sort());
});
