// Unpacks the other scripts of the page and runs them at once; the page's policy allows them by their hash.

import {unpacked} from './loader.js';

{
  const script = document.createElement('script');
  script.textContent = new TextDecoder().decode(unpacked('page-scripts'));
  document.head.append(script);
}
