package arcomat.sim.load;

import org.objectweb.asm.Opcodes;
import org.objectweb.asm.Type;
import org.objectweb.asm.tree.AbstractInsnNode;
import org.objectweb.asm.tree.ClassNode;
import org.objectweb.asm.tree.FieldNode;
import org.objectweb.asm.tree.FrameNode;
import org.objectweb.asm.tree.InsnList;
import org.objectweb.asm.tree.InsnNode;
import org.objectweb.asm.tree.IntInsnNode;
import org.objectweb.asm.tree.MethodInsnNode;
import org.objectweb.asm.tree.MethodNode;
import org.objectweb.asm.tree.TryCatchBlockNode;
import org.objectweb.asm.tree.TypeInsnNode;
import org.objectweb.asm.tree.VarInsnNode;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/**
 * Lets one method of a program tell the simulated machine what it does: calls, work, objects made,
 * and objects held in variables. What it computes stays the same.
 */
final class Metering {
    private static final String INITIALIZER = "<clinit>";
    private static final String CONSTRUCTOR = "<init>";

    /** What a call takes on leJOS' stack besides its words. */
    private static final int FRAME = 20;

    private static final int WORD = 4;

    /**
     * Methods that Java's own collections call, some of which are locked then, by the PC: a thread
     * that lets others go on there would never get its turn again.
     */
    private static final Set<String> IN_COLLECTIONS =
            Set.of("compare", "compareTo", "equals", "hashCode", "toString");

    private final MethodNode method;
    private final Variables variables;
    private final Creations creations;
    private final Set<AbstractInsnNode> handlers = new HashSet<>();

    /** The variable that keeps the depth of the call, where errors are caught. */
    private final int depth;

    private Metering(MethodNode method) {
        this.method = method;
        this.variables = Variables.of(method);
        this.creations = Creations.of(method);
        this.depth = method.maxLocals;
        for (TryCatchBlockNode block : method.tryCatchBlocks) {
            AbstractInsnNode first = block.handler;
            while (first != null && first.getOpcode() < 0) {
                first = first.getNext();
            }
            handlers.add(first);
        }
    }

    /** Meters all methods of a class. */
    static void meter(ClassNode type) {
        List<MethodNode> methods = new ArrayList<>(type.methods);
        for (MethodNode method : methods) {
            if (method.instructions.size() > 0) {
                new Metering(method).meter();
            }
        }
        if (type.fields.stream().anyMatch(Metering::isHeld)) {
            announce(type);
        }
    }

    private static boolean isHeld(FieldNode field) {
        return (field.access & Opcodes.ACC_STATIC) != 0
                && field.value == null
                && Variables.isObject(Type.getType(field.desc));
    }

    /** A class whose own variables hold objects says when these begin to exist. */
    private static void announce(ClassNode type) {
        MethodNode initializer =
                type.methods.stream()
                        .filter(method -> method.name.equals(INITIALIZER))
                        .findFirst()
                        .orElse(null);
        if (initializer == null) {
            initializer = new MethodNode(Opcodes.ACC_STATIC, INITIALIZER, "()V", null, null);
            initializer.instructions.add(new InsnNode(Opcodes.RETURN));
            type.methods.add(initializer);
        }
        initializer.instructions.insert(
                MachineCalls.call("initialized", Type.getObjectType(type.name)));
    }

    private void meter() {
        Blocks blocks = Blocks.of(method);
        for (AbstractInsnNode each : method.instructions.toArray()) {
            if (handlers.contains(each)) {
                put(each, caught());
            }
            if (blocks.costs().containsKey(each)) {
                put(each, work(blocks.costs().get(each)));
            }
            if (each instanceof FrameNode frame) {
                keepDepth(frame);
            } else if (each.getOpcode() >= 0) {
                meter(each);
            }
        }
        method.instructions.insert(entry(blocks.first()));
    }

    private InsnList work(int microseconds) {
        return IN_COLLECTIONS.contains(method.name)
                ? MachineCalls.count(microseconds)
                : MachineCalls.work(microseconds);
    }

    /** Before an instruction; but frames name a NEW by its place, so nothing comes before that. */
    private void put(AbstractInsnNode instruction, InsnList added) {
        if (instruction.getOpcode() == Opcodes.NEW) {
            method.instructions.insert(instruction, added);
        } else {
            method.instructions.insertBefore(instruction, added);
        }
    }

    private InsnList entry(int work) {
        InsnList entry = new InsnList();
        int frame = FRAME + WORD * (method.maxLocals + method.maxStack);
        entry.add(MachineCalls.enter(variables.size(), frame, work));
        entry.add(
                handlers.isEmpty()
                        ? new InsnNode(Opcodes.POP)
                        : new VarInsnNode(Opcodes.ISTORE, depth));
        for (int parameter : variables.parameters()) {
            // Before it is initialized, an object cannot be shown to anybody.
            if (parameter > 0 || !method.name.equals(CONSTRUCTOR)) {
                entry.add(hold(parameter));
            }
        }
        return entry;
    }

    private InsnList hold(int local) {
        InsnList code = new InsnList();
        code.add(new VarInsnNode(Opcodes.ALOAD, local));
        code.add(MachineCalls.hold(variables.number(local)));
        return code;
    }

    private InsnList caught() {
        InsnList code = new InsnList();
        code.add(new VarInsnNode(Opcodes.ILOAD, depth));
        code.add(MachineCalls.caught(variables.size()));
        return code;
    }

    /** The depth is known everywhere in a method that keeps it. */
    private void keepDepth(FrameNode frame) {
        if (handlers.isEmpty()) {
            return;
        }
        List<Object> locals = new ArrayList<>(frame.local);
        int words = 0;
        for (Object local : locals) {
            words += local == Opcodes.LONG || local == Opcodes.DOUBLE ? 2 : 1;
        }
        for (; words < depth; words++) {
            locals.add(Opcodes.TOP);
        }
        locals.add(Opcodes.INTEGER);
        frame.local = locals;
    }

    private void meter(AbstractInsnNode each) {
        int opcode = each.getOpcode();
        InsnList code = method.instructions;
        if (opcode == Opcodes.NEW) {
            code.insert(
                    each,
                    MachineCalls.call("make", Type.getObjectType(((TypeInsnNode) each).desc)));
        } else if (opcode == Opcodes.NEWARRAY) {
            code.insertBefore(each, MachineCalls.makeArray(((IntInsnNode) each).operand));
        } else if (opcode == Opcodes.ANEWARRAY) {
            code.insertBefore(each, MachineCalls.makeArrayOfObjects());
        } else if (opcode == Opcodes.MULTIANEWARRAY) {
            code.insert(each, MachineCalls.given());
        } else if (opcode >= Opcodes.IRETURN && opcode <= Opcodes.RETURN) {
            code.insertBefore(each, MachineCalls.leave());
        } else if (opcode >= Opcodes.ISTORE && opcode <= Opcodes.ASTORE) {
            store((VarInsnNode) each);
        } else if (each instanceof MethodInsnNode call) {
            meter(call);
        }
    }

    private void store(VarInsnNode store) {
        if (store.getOpcode() == Opcodes.ASTORE) {
            if (variables.contains(store.var)) {
                InsnList held = new InsnList();
                held.add(new InsnNode(Opcodes.DUP));
                held.add(MachineCalls.hold(variables.number(store.var)));
                method.instructions.insertBefore(store, held);
            }
            return;
        }
        forget(store, store.var);
        if (store.getOpcode() == Opcodes.LSTORE || store.getOpcode() == Opcodes.DSTORE) {
            forget(store, store.var + 1);
        }
    }

    /** A number takes the place of an object. */
    private void forget(VarInsnNode store, int local) {
        if (variables.contains(local)) {
            InsnList code = new InsnList();
            code.add(new InsnNode(Opcodes.ACONST_NULL));
            code.add(MachineCalls.hold(variables.number(local)));
            method.instructions.insert(store, code);
        }
    }

    private void meter(MethodInsnNode call) {
        InsnList code = method.instructions;
        if (call == creations.ofItself() && method.name.equals(CONSTRUCTOR)) {
            code.insert(call, hold(0));
        } else if (call.name.equals(CONSTRUCTOR)) {
            if (creations.kept().contains(call) && ForeignCalls.isJavas(call)) {
                code.insert(call, MachineCalls.given());
                if (ForeignCalls.isError(call.owner)) {
                    code.insert(call, MachineCalls.made());
                }
            }
        } else if (ForeignCalls.waitsForSlice(call)) {
            code.insertBefore(call, MachineCalls.await());
            code.insert(call, MachineCalls.awaited());
        } else if (ForeignCalls.givesObject(call)) {
            code.insert(call, MachineCalls.given());
        } else if (ForeignCalls.grows(call)) {
            code.insert(call, MachineCalls.grown(ForeignCalls.growth(call)));
        }
    }
}
