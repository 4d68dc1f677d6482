package arcomat.pipeline.brick;

import java.util.Optional;

/**
 * A program that is to be linked.
 *
 * @param jar path of its jar
 * @param out path of the program for the brick; empty for beside the jar
 * @param nxjHome folder of leJOS NXJ; empty where nobody said
 * @param seconds how long the linker may take
 */
public record LinkRequest(
        String jar, Optional<String> out, Optional<String> nxjHome, int seconds) {}
