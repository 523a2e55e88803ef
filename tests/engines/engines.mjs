// The free body of tests/engines/run in JavaScript's engines: node engines.mjs rapier|cannon STEP_S SPAN_S
const [engine, step, span] = [process.argv[2], Number(process.argv[3]), Number(process.argv[4])];

// The vector in body axes: q⁻¹ v q.
function inBody(q, v) {
    const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
    const u = [-q.x, -q.y, -q.z], t = cross(u, v).map(x => 2 * x), s = cross(u, t);
    return v.map((x, i) => x + q.w * t[i] + s[i]);
}
const lines = ["time,q_w,q_x,q_y,q_z,omega_x,omega_y,omega_z"];
function note(k, q, w) {
    lines.push([k * step, q.w, q.x, q.y, q.z, ...inBody(q, [w.x, w.y, w.z])].join(","));
}

if (engine === "rapier") {
    const { default: RAPIER } = await import("@dimforge/rapier3d-compat");
    await RAPIER.init();
    const world = new RAPIER.World({ x: 0, y: 0, z: 0 });
    world.timestep = step;
    const body = world.createRigidBody(RAPIER.RigidBodyDesc.dynamic()
        .setAdditionalMassProperties(1, { x: 0, y: 0, z: 0 }, { x: 4, y: 3, z: 1.5 }, { w: 1, x: 0, y: 0, z: 0 })
        .setAngvel({ x: 1.2, y: 0.8, z: 2.4 }).setCanSleep(false).setAngularDamping(0));
    for (let k = 0; k * step <= span; ++k) { note(k, body.rotation(), body.angvel()); world.step(); }
} else {
    const CANNON = await import("cannon-es");
    const world = new CANNON.World({ gravity: new CANNON.Vec3(0, 0, 0) });
    const body = new CANNON.Body({ mass: 1, angularDamping: 0, linearDamping: 0, allowSleep: false });
    body.inertia.set(4, 3, 1.5);
    body.invInertia.set(1 / 4, 1 / 3, 1 / 1.5);
    body.updateInertiaWorld(true);
    body.angularVelocity.set(1.2, 0.8, 2.4);
    world.addBody(body);
    for (let k = 0; k * step <= span; ++k) { note(k, body.quaternion, body.angularVelocity); world.step(step); }
}
process.stdout.write(lines.join("\n") + "\n");
