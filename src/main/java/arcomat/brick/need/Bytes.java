package arcomat.brick.need;

import arcomat.brick.need.flow.Constants;
import arcomat.brick.need.flow.MethodName;
import arcomat.brick.need.flow.Unknown;
import arcomat.sim.memory.ObjectLayout;

import org.objectweb.asm.Opcodes;
import org.objectweb.asm.tree.AbstractInsnNode;
import org.objectweb.asm.tree.ClassNode;
import org.objectweb.asm.tree.FieldNode;
import org.objectweb.asm.tree.IntInsnNode;
import org.objectweb.asm.tree.LdcInsnNode;
import org.objectweb.asm.tree.MultiANewArrayInsnNode;
import org.objectweb.asm.tree.TypeInsnNode;

import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;

/**
 * How much memory the objects take that methods make, in bytes. Each counts once, as if it stayed:
 * what is thrown away is in memory, too, until it is collected.
 */
final class Bytes extends MethodWeights {
    private static final String THREAD = "java/lang/Thread";
    private static final String OBJECT = "java/lang/Object";
    private static final int[] ELEMENTS = {1, 2, 4, 8, 1, 2, 4, 8};

    private final boolean isWithTexts;
    private final Stacks stacks;

    /**
     * @param isWithTexts whether texts written in the code count, too: the machine makes them anew
     *     each time; what slices make is left out then
     */
    Bytes(Code code, LibraryCost library, boolean isWithTexts) {
        this(code, library, isWithTexts, Map.of());
    }

    private Bytes(Code code, LibraryCost library, boolean isWithTexts, Map<String, Long> sizes) {
        super(code, library, sizes);
        this.isWithTexts = isWithTexts;
        this.stacks = new Stacks(code);
    }

    /** The stack of the thread that a method is the first of. */
    long stack(MethodName first) {
        return stacks.bytes(first);
    }

    /** The statics of a class. */
    static long statics(ClassNode node) {
        return node.fields.stream()
                .filter(field -> isStatic(field) && field.value == null)
                .mapToLong(field -> ObjectLayout.value(field.desc))
                .sum();
    }

    @Override
    protected long own(AbstractInsnNode instruction) {
        if (instruction instanceof TypeInsnNode i && i.getOpcode() == Opcodes.NEW) {
            return object(i.desc);
        } else if (instruction instanceof TypeInsnNode i && i.getOpcode() == Opcodes.ANEWARRAY) {
            return ObjectLayout.array(length(i), ObjectLayout.REFERENCE);
        } else if (instruction instanceof IntInsnNode i && i.getOpcode() == Opcodes.NEWARRAY) {
            return ObjectLayout.array(
                    length(i), ELEMENTS[Math.floorMod(i.operand - Opcodes.T_BOOLEAN, 8)]);
        } else if (instruction instanceof MultiANewArrayInsnNode i) {
            return arrays(i);
        } else if (instruction instanceof LdcInsnNode i && i.cst instanceof String text) {
            return !isWithTexts ? 0 : ObjectLayout.text(text.length());
        }
        return 0;
    }

    @Override
    protected MethodWeights ofMonitor(Code alone, Map<String, Long> ofIts) {
        return new Bytes(alone, library, isWithTexts, ofIts);
    }

    @Override
    protected boolean isLookedInto(MethodName method) {
        return !isValues(method)
                && !library.isApart(method)
                && !(isWithTexts && method.equals(Entry.SLICES));
    }

    /** An enum copies its constants for whoever asks; methods of leJOS keep nothing. */
    @Override
    protected long ofLibrary(MethodName method) {
        return isValues(method)
                ? ObjectLayout.array(constants(method.owner()), ObjectLayout.REFERENCE)
                : 0;
    }

    private boolean isValues(MethodName method) {
        return method.name().equals("values")
                && method.descriptor().equals("()[L" + method.owner() + ";")
                && code.type(method.owner()).filter(t -> isEnum(t.access)).isPresent();
    }

    private long constants(String type) {
        return code.type(type).orElseThrow().fields.stream()
                .filter(field -> isEnum(field.access))
                .count();
    }

    private static boolean isEnum(int access) {
        return (access & Opcodes.ACC_ENUM) != 0;
    }

    private long object(String type) {
        long fields = 0;
        for (String each : code.withSupertypes(type)) {
            Optional<ClassNode> own = code.type(each);
            if (own.isPresent()) {
                fields += fields(own.get());
            } else if (!each.equals(OBJECT) && isClass(each)) {
                // It has its own superclasses counted in.
                return ObjectLayout.aligned(fields + library.bytesOfObject(each))
                        + stackOf(each, type);
            }
        }
        return ObjectLayout.object(fields);
    }

    private boolean isClass(String type) {
        return code.library(type).map(t -> !t.isInterface()).orElse(false);
    }

    private static long fields(ClassNode node) {
        return node.fields.stream()
                .filter(field -> !isStatic(field))
                .mapToLong(field -> ObjectLayout.value(field.desc))
                .sum();
    }

    private long stackOf(String superclass, String type) {
        return superclass.equals(THREAD) && !type.equals(THREAD)
                ? stack(new MethodName(type, "run", "()V"))
                : 0;
    }

    private long arrays(MultiANewArrayInsnNode made) {
        AbstractInsnNode each = made;
        long[] lengths = new long[made.dims];
        for (int i = made.dims - 1; i >= 0; i--) {
            each = Constants.before(each);
            lengths[i] = constant(each);
        }
        long bytes = 0;
        long number = 1;
        for (int i = 0; i < made.dims; i++) {
            int element =
                    ObjectLayout.value(
                            made.desc.substring(Math.min(i + 1, made.desc.length() - 1)));
            bytes =
                    Math.addExact(
                            bytes,
                            Math.multiplyExact(number, ObjectLayout.array(lengths[i], element)));
            number = Math.multiplyExact(number, lengths[i]);
        }
        return bytes;
    }

    private static long length(AbstractInsnNode made) {
        return constant(Constants.before(made));
    }

    private static long constant(AbstractInsnNode instruction) {
        OptionalInt length = Constants.pushed(instruction);
        if (length.isEmpty()) {
            throw new Unknown("the length of an array is not written as a number");
        }
        return Math.max(0, length.getAsInt());
    }

    private static boolean isStatic(FieldNode field) {
        return (field.access & Opcodes.ACC_STATIC) != 0;
    }
}
