package arcomat.brick.need;

import arcomat.brick.need.flow.MethodName;
import arcomat.brick.need.flow.Unknown;

import org.objectweb.asm.tree.AbstractInsnNode;
import org.objectweb.asm.tree.MethodInsnNode;
import org.objectweb.asm.tree.MethodNode;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * The stacks of threads: one of calls and one of values, each of which starts small, grows where it
 * is too short and never shrinks.
 */
final class Stacks {
    private static final int BYTES_OF_FRAME = 20;
    private static final int FRAMES_AT_ONCE = 4;
    private static final int WORDS_AT_ONCE = 10;
    private static final int WORD = 4;
    private static final int HEADERS = 12;

    /** Of methods of leJOS, which call each other, too. */
    private static final Depth LIBRARY = new Depth(6, 40);

    /**
     * @param frames calls that wait for each other
     * @param words of their locals and of what they calculate with
     */
    private record Depth(long frames, long words) {
        Depth or(Depth other) {
            return new Depth(Math.max(frames, other.frames), Math.max(words, other.words));
        }
    }

    private final Code code;
    private final Map<MethodName, Depth> known = new HashMap<>();
    private final Set<MethodName> open = new HashSet<>();

    Stacks(Code code) {
        this.code = code;
    }

    /**
     * @param first the method that the thread starts with
     * @throws Unknown if methods call themselves
     */
    long bytes(MethodName first) {
        Depth depth = depth(first);
        return HEADERS
                + inSteps(depth.frames(), FRAMES_AT_ONCE) * BYTES_OF_FRAME
                + inSteps(depth.words(), WORDS_AT_ONCE) * WORD;
    }

    private static long inSteps(long number, int step) {
        return (number + step - 1) / step * step;
    }

    private Depth depth(MethodName method) {
        Optional<MethodNode> body = code.method(method);
        if (body.isEmpty()) {
            return LIBRARY;
        }
        Depth before = known.get(method);
        if (before != null) {
            return before;
        }
        if (!open.add(method)) {
            throw Unknown.of(method, "calls itself");
        }
        Depth deepest = new Depth(0, 0);
        for (AbstractInsnNode each : body.get().instructions) {
            if (each instanceof MethodInsnNode call) {
                for (MethodName target : code.targets(call)) {
                    deepest = deepest.or(depth(target));
                }
            }
        }
        open.remove(method);
        Depth depth =
                new Depth(
                        deepest.frames() + 1,
                        deepest.words() + body.get().maxLocals + body.get().maxStack);
        known.put(method, depth);
        return depth;
    }
}
