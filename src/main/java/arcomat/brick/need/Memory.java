package arcomat.brick.need;

import arcomat.brick.api.BrickType;
import arcomat.brick.need.flow.MethodName;
import arcomat.brick.need.flow.Unknown;

import org.objectweb.asm.tree.AbstractInsnNode;
import org.objectweb.asm.tree.ClassNode;

import java.util.List;

/**
 * How much memory a program needs at most: what it makes along its heaviest way, the stacks of its
 * threads, those of its listeners among them, and what leJOS keeps for itself.
 */
record Memory(Code code, LibraryCost library, Entry entry, LinkedClasses linked) {

    private static final String THREAD = "java/lang/Thread";
    private static final String LISTENER = "Listener";

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
                + listeners()
                + new RobotMonitors(code, library).bytes(main)
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

    /**
     * Threads of leJOS that tell the program what happens, one for each class that listens, and
     * what these make.
     */
    private long listeners() {
        Bytes bytes = new Bytes(code, library, false);
        long sum = 0;
        for (ClassNode node : code.classes()) {
            for (String type : code.withSupertypes(node.name)) {
                if (type.endsWith(LISTENER)) {
                    sum += code.library(type).map(told -> thread(node, told, bytes)).orElse(0L);
                }
            }
        }
        return sum;
    }

    private long thread(ClassNode listener, BrickType told, Bytes bytes) {
        List<MethodName> called =
                listener.methods.stream()
                        .filter(method -> told.method(method.name, method.desc).isPresent())
                        .map(method -> new MethodName(listener.name, method.name, method.desc))
                        .toList();
        return library.bytesOfObject(THREAD)
                + called.stream().mapToLong(bytes::stack).max().orElse(0)
                + called.stream().mapToLong(bytes::of).sum();
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
