package arcomat.brick.need;

import org.objectweb.asm.tree.AbstractInsnNode;

/**
 * How much memory a program needs at most: what it makes along its heaviest way, the stacks of its
 * threads, and what leJOS keeps for itself.
 */
record Memory(Code code, LibraryCost library, Entry entry, LinkedClasses linked) {

    /**
     * What leJOS has made before the first of the program's instructions, and the classes of every
     * program keep. Calibrated on one robot (the preparer of the case study); the others test it.
     */
    private static final long LEJOS = 1850;

    /**
     * @throws Unknown if that cannot be told
     */
    long bytes() {
        Bytes bytes = new Bytes(code, library, true);
        MethodName main = entry.main();
        return LEJOS
                + ofLibrary()
                + statics(bytes)
                + bytes.of(main)
                + bytes.stack(main)
                + (entry.isRobot() ? ofSlice() : 0);
    }

    /**
     * Objects that a slice makes may stay. The texts in it are those of errors and of what is
     * shown: none of them does.
     */
    private long ofSlice() {
        Bytes bytes = new Bytes(code, library, false);
        long sum = 0;
        for (AbstractInsnNode each : entry.slices().instructions) {
            sum = Math.addExact(sum, bytes.of(each));
        }
        return sum;
    }

    private long ofLibrary() {
        return linked.names().stream().mapToLong(library::bytesOf).sum();
    }

    private long statics(Bytes bytes) {
        return code.classes().stream()
                .mapToLong(
                        node ->
                                Bytes.statics(node)
                                        + bytes.of(new MethodName(node.name, "<clinit>", "()V")))
                .sum();
    }
}
