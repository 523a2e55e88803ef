// Turns a mesh of three.js as the body turns:
//   poinsot sample generic --times 0:10/241 -o motion.json
import { AnimationClip, AnimationMixer, Clock } from "three";

export async function turn(mesh, renderer, scene, camera) {
    const clip = AnimationClip.parse(await (await fetch("motion.json")).json());
    const mixer = new AnimationMixer(mesh);
    mixer.clipAction(clip).play();
    const clock = new Clock();
    renderer.setAnimationLoop(() => {
        mixer.update(clock.getDelta());
        renderer.render(scene, camera);
    });
}
