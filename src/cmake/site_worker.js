// Keeps the site for use without a network: what was opened, and the first files. Online, everything is fetched anew.
const kept = `poinsot ${self.registration.scope} {{version}}`;
const first_files = {{files}};

self.addEventListener('install', (event) => event.waitUntil(caches.open(kept).then((cache) => cache.addAll(first_files)).then(() => self.skipWaiting())));
self.addEventListener('activate', (event) => event.waitUntil(caches.keys().then((names) => Promise.all(
  names.filter((name) => name.startsWith(`poinsot ${self.registration.scope} `) && name !== kept).map((name) => caches.delete(name)))).then(() => self.clients.claim())));
self.addEventListener('fetch', (event) => {
  const {request} = event;
  if (request.method !== 'GET' || new URL(request.url).origin !== self.location.origin) return;
  event.respondWith(caches.open(kept).then(async (cache) => {
    try {
      const answer = await fetch(request);
      // Not parts of files.
      if (answer.status === 200) await cache.put(request, answer.clone());
      return answer;
    } catch {
      return (await cache.match(request, {ignoreSearch: true})) ?? Response.error();
    }
  }));
});
