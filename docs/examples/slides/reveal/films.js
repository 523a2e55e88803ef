// Plays the films of slides: forwards from the picture of the slide before, backwards to the picture
// at which the film stops. A second video is a loop; it goes on until the slide's fragment is shown.
'use strict';

const pictures_of = (slide) => [...slide.querySelectorAll(':scope > img, :scope > video')];

/** Shows one of a slide's pictures as soon as it has something to show; until then the last one stays. */
function show(slide, picture) {
  slide.wanted = picture;
  const swap = () => {
    if (slide.wanted === picture) pictures_of(slide).forEach((other) => other.classList.toggle('shown', other === picture));
  };
  if (picture.requestVideoFrameCallback) picture.requestVideoFrameCallback(swap);
  else swap();
}

function play(slide, video) {
  show(slide, video);
  video.currentTime = 0;
  // It fails if the slide is left before the film begins.
  video.play().catch(() => {});
}

function enter(slide, forwards) {
  const [film, loop] = slide.querySelectorAll('video');
  if (!film) return;
  const still = slide.querySelector('img');
  const ended = loop && slide.querySelector('.fragment.visible');
  film.onended = () => loop && play(slide, loop);
  if (loop) {
    loop.loop = true;
    loop.onended = () => Reveal.next();
  }
  if (forwards && !ended) play(slide, film);
  else show(slide, still);
}

function leave(slide) {
  for (const video of slide.querySelectorAll('video')) {
    video.onended = null;
    video.pause();
  }
}

Reveal.on('ready', ({currentSlide}) => enter(currentSlide, true));
Reveal.on('slidechanged', ({currentSlide, previousSlide}) => {
  const slides = Reveal.getSlides();
  const forwards = slides.indexOf(currentSlide) > slides.indexOf(previousSlide);
  if (previousSlide) leave(previousSlide);
  enter(currentSlide, forwards);
});
Reveal.on('fragmentshown', ({fragment}) => {
  const slide = fragment.closest('section.film');
  const loop = slide && slide.querySelectorAll('video')[1];
  if (!loop) return;
  if (loop.paused) {
    // Pressed before the loop: on to the loop, and the fragment is there for the next press.
    setTimeout(() => Reveal.prevFragment(), 0);
    return;
  }
  loop.loop = false;
});
Reveal.on('fragmenthidden', ({fragment}) => {
  const slide = fragment.closest('section.film');
  const loop = slide && slide.querySelectorAll('video')[1];
  if (!loop) return;
  leave(slide);
  enter(slide, false);
  play(slide, loop);
});
