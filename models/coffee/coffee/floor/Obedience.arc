package coffee.floor;

import coffee.floor.Orders.*;
import coffee.types.Types.*;

/** Who is told to hold stops in that slice, and is not told to move before it may go on. */
component Obedience {
    timing instant;

    port in MotorCmd wanted, in Order order, out MotorCmd cmd;

    <<completion = "output">> automaton {
        state free, held;

        initial free;

        free -> held {order == hold} / {cmd = stop};

        held {order == hold};
        held {order == hold} / {cmd = stop};
        held {order == --};
        held -> free {order == go} / {cmd = fwd};
        held -> free {order == go} / {cmd = stop};
        held -> free {order == go} / {cmd = backRight};
        held -> free {order == go};
    }
}
