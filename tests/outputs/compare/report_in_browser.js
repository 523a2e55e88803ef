// Opens reports in a window of each width, waits until their driver has said its claims, and prints these.
// Usage: node report_in_browser.js PAGE WIDTH [PAGE WIDTH]...
'use strict';
const assert = require('node:assert/strict');
const {browser_checks, opened_file, until} = require('../../doors/web/browsers.js');

const files = process.argv.slice(2);
const check = browser_checks();
for (let i = 0; i < files.length; i += 2) {
  const [file, width] = [files[i], Number(files[i + 1])];
  check(`${file} in ${width} pixels`, async (browser) => {
    const {tab, faults} = await opened_file(browser, file, {size: {width, height: 800}});
    await until(tab, 'document.getElementById("claims").textContent !== ""', 120000);
    const claims = JSON.parse(await tab.$eval('#claims', (element) => element.textContent));
    for (const [name, holds] of claims) console.log(holds ? 'holds' : 'FAILS', name);
    assert.ok(claims.length > 0 && claims.every(([, holds]) => holds), 'a claim fails');
    assert.deepEqual(faults, []);
    await tab.close();
  });
}
