package arcomat.sim.load;

import java.util.Optional;

/**
 * Class files of what is loaded once per brick, by the full names of their classes: those of a
 * program, and those of leJOS.
 */
interface ClassFiles {
    /** Empty if there is no such class. */
    Optional<byte[]> find(String name);
}
