package coffee.floor;

import coffee.floor.Orders.*;
import coffee.types.Types.*;

/**
 * Stands between the one who decides and the wheels: an order from outside holds the robot. What
 * was wanted meanwhile is made good when it may go on.
 */
component Halt refines Obedience {
    timing instant;

    port in MotorCmd wanted, in Order order, out MotorCmd cmd;

    <<completion = "ignore">> automaton {
        state free, held;

        /** What was wanted last. */
        variable MotorCmd last = stop;

        initial free;

        free {wanted == fwd, order == --} / {cmd = fwd, last = fwd};
        free {wanted == stop, order == --} / {cmd = stop, last = stop};
        free {wanted == backRight, order == --} / {cmd = backRight, last = backRight};
        free -> held {wanted == --, order == hold} / {cmd = stop};
        free -> held {wanted == fwd, order == hold} / {cmd = stop, last = fwd};
        free -> held {wanted == stop, order == hold} / {cmd = stop, last = stop};
        free -> held {wanted == backRight, order == hold} / {cmd = stop, last = backRight};
        // Nobody held it: the order is late.
        free {wanted == fwd, order == go} / {cmd = fwd, last = fwd};
        free {wanted == stop, order == go} / {cmd = stop, last = stop};
        free {wanted == backRight, order == go} / {cmd = backRight, last = backRight};

        held {wanted == fwd, order == --} / {last = fwd};
        held {wanted == stop, order == --} / {last = stop};
        held {wanted == backRight, order == --} / {last = backRight};
        held -> free {wanted == --, order == go} / {cmd = last};
        held -> free {wanted == fwd, order == go} / {cmd = fwd, last = fwd};
        held -> free {wanted == stop, order == go} / {cmd = stop, last = stop};
        held -> free {wanted == backRight, order == go} / {cmd = backRight, last = backRight};
    }
}
