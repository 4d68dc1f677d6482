package arcomat.world;

/**
 * Something on a robot that senses the world or works in it. Sockets are 1 to 4, motors 1 to 3;
 * places are in mm from the robot's middle, x to its front, y to its left.
 */
public sealed interface Device {
    /** A device that is read through a socket. */
    sealed interface Sensor extends Device {
        int socket();

        /** What it tells: cm, percent, or 1 for pressed. */
        int read(Senses.View view);
    }

    /** A sensor of which it matters where on the robot it is. */
    sealed interface Placed extends Sensor {
        Point place();
    }

    /**
     * Sees the nearest surface in a cone.
     *
     * @param facing in radians from the robot's front to the left
     */
    record Ultrasonic(int socket, Point place, double facing) implements Placed {
        @Override
        public int read(Senses.View view) {
            return view.echo(place, facing);
        }
    }

    /** Sees the brightness of the floor below it. */
    record Light(int socket, Point place) implements Placed {
        @Override
        public int read(Senses.View view) {
            return view.floor(place);
        }
    }

    /** A touch sensor at the front: pressed while the robot pushes against something. */
    record Bumper(int socket) implements Sensor {
        @Override
        public int read(Senses.View view) {
            return view.robot().touching() || view.robot().pushing() ? 1 : 0;
        }
    }

    /** Carries a cup; a full one is heavy enough to press the touch sensor below it. */
    record Holder(int socket, Point place) implements Placed {
        @Override
        public int read(Senses.View view) {
            return view.robot().cup() == World.Cup.FULL ? 1 : 0;
        }
    }

    /** An ultrasonic sensor that looks down where cups drop. */
    record Chute(int socket, Point place) implements Placed {
        @Override
        public int read(Senses.View view) {
            return view.below(place);
        }
    }

    /** A touch sensor that feels the stack of cups. */
    record Magazine(int socket, int cups) implements Sensor {
        @Override
        public int read(Senses.View view) {
            return view.robot().stock() > 0 ? 1 : 0;
        }
    }

    /** A touch sensor that feels a cup below the spout. */
    record Feeler(int socket, Point place) implements Placed {
        @Override
        public int read(Senses.View view) {
            return view.isCupAt(place) ? 1 : 0;
        }
    }

    /** A light sensor that looks at the lamp of the coffee machine. */
    record Lamp(int socket) implements Sensor {
        @Override
        public int read(Senses.View view) {
            return view.lamp(view.robot().brewing() == 0);
        }
    }

    /** Pushes one cup down the chute when it is turned out. */
    record Slide(int motor) implements Device {}

    /**
     * Presses the button of the coffee machine when it is turned out.
     *
     * @param seconds that the machine takes for a cup
     */
    record Finger(int motor, double seconds) implements Device {}
}
