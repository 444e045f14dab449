// SPDX-License-Identifier: Apache-2.0
// planck, a port of Box2D in double precision, in the plane.
import { Box, Circle, Edge, Settings, Vec2, World } from "planck";

Settings.velocityThreshold = 0;
Settings.maxTranslation = 1e6;

export const hello = {
  cannot: ["particles", "stick", "penalty", "space"],
  thresholds: ["0.01 m of skin on boxes and walls (polygonRadius)", "0.005 m of depth are left (linearSlop)"],
};

const longWay = 1000;  // metres, half the length of a wall

export function start({ gravity, timestep, restitution, option, bodies, walls }) {
  const continuous = option === 2;
  const world = new World({ gravity: Vec2(gravity[0], gravity[1]), allowSleep: false, continuousPhysics: continuous });
  const made = bodies.map((body, i) => {
    const one = world.createBody({
      type: body.fixed ? "static" : "dynamic", position: Vec2(body.position[0], body.position[1]),
      linearVelocity: Vec2(body.velocity[0], body.velocity[1]), fixedRotation: true, bullet: continuous, userData: i,
    });
    const shape = body.shape === "sphere" ? new Circle(body.radius) : new Box(...body.half_extents.slice(0, 2));
    one.createFixture({ shape, density: 1, friction: 0, restitution });
    if (!body.fixed) one.setMassData({ mass: body.mass, center: Vec2(0, 0), I: 0 });
    return one;
  });
  walls.forEach(({ normal: [x, y, z], offset }, i) => {
    if (z !== 0) return;
    const at = (t) => Vec2(-offset * x - t * y, -offset * y + t * x);
    const wall = world.createBody({ type: "static", userData: bodies.length + i });
    wall.createFixture({ shape: new Edge(at(-longWay), at(longWay)), friction: 0, restitution });
  });
  let met;
  world.on("post-solve", (contact, impulse) => {
    if (impulse.normalImpulses.some((x) => x > 0))
      met(contact.getFixtureA().getBody().getUserData(), contact.getFixtureB().getBody().getUserData());
  });
  return {
    step(report) {
      met = report;
      world.step(timestep, 8, 3);
    },
    body(i) {
      const p = made[i].getPosition(), v = made[i].getLinearVelocity();
      return [p.x, p.y, 0, v.x, v.y, 0];
    },
  };
}
