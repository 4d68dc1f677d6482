package arcomat.sim.load;

import org.jspecify.annotations.Nullable;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.Type;
import org.objectweb.asm.tree.AbstractInsnNode;
import org.objectweb.asm.tree.InsnList;
import org.objectweb.asm.tree.InsnNode;
import org.objectweb.asm.tree.JumpInsnNode;
import org.objectweb.asm.tree.LabelNode;
import org.objectweb.asm.tree.MethodInsnNode;
import org.objectweb.asm.tree.MethodNode;
import org.objectweb.asm.tree.TypeInsnNode;
import org.objectweb.asm.tree.VarInsnNode;
import org.objectweb.asm.tree.analysis.Analyzer;
import org.objectweb.asm.tree.analysis.AnalyzerException;
import org.objectweb.asm.tree.analysis.BasicValue;
import org.objectweb.asm.tree.analysis.Frame;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/**
 * A method that can be left in the middle of a call, and entered there again: when the call comes
 * back because the thread rests, the method saves its variables and returns; called anew, it takes
 * them and makes the call again. Everything else stays as it is (Pettyjohn, Clements, Marshall,
 * Krishnamurthi, Felleisen, Continuations from generalized stack inspection, ICFP 2005).
 */
final class ReentrantMethod {
    private static final String RESTS = "arcomat/sim/inside/BrickRests";
    private static final String OBJECT = "Ljava/lang/Object;";

    private final MethodNode method;
    private final MethodInsnNode call;
    private final boolean isOutermost;
    private final List<Variable> arguments = new ArrayList<>();
    private final List<Variable> variables = new ArrayList<>();

    private record Variable(int local, Type type) {
        VarInsnNode load() {
            return new VarInsnNode(type.getOpcode(Opcodes.ILOAD), local);
        }

        VarInsnNode store() {
            return new VarInsnNode(type.getOpcode(Opcodes.ISTORE), local);
        }
    }

    private ReentrantMethod(MethodNode method, MethodInsnNode call, boolean isOutermost) {
        this.method = method;
        this.call = call;
        this.isOutermost = isOutermost;
    }

    /**
     * Changes a method of a class. Frames have to be computed afterwards.
     *
     * @param owner internal name of the class
     * @param isOutermost whether nobody is there who calls it anew: then its object is what is
     *     saved last, for whoever does
     * @throws Unrepeatable where the method holds something that cannot be saved
     */
    static void change(String owner, MethodNode method, MethodInsnNode call, boolean isOutermost) {
        ReentrantMethod reentrant = new ReentrantMethod(method, call, isOutermost);
        reentrant.findVariables(frame(owner, method, call));
        reentrant.write();
    }

    private static Frame<BasicValue> frame(String owner, MethodNode method, MethodInsnNode call) {
        try {
            Frame<BasicValue>[] frames = new Analyzer<>(new ExactTypes()).analyze(owner, method);
            @Nullable Frame<BasicValue> frame = frames[method.instructions.indexOf(call)];
            if (frame != null) {
                return frame;
            }
        } catch (AnalyzerException e) {
            throw refused(method, "is no valid code");
        }
        throw refused(method, "never comes to the call");
    }

    private static Unrepeatable refused(MethodNode method, String why) {
        return new Unrepeatable(method.name + " " + why);
    }

    /** What it has at the call, and places for what it passes on. */
    private void findVariables(Frame<BasicValue> frame) {
        boolean hasObject = (method.access & Opcodes.ACC_STATIC) == 0;
        requireObjectKept(hasObject);
        for (int local = hasObject ? 1 : 0; local < frame.getLocals(); local++) {
            Type type = frame.getLocal(local).getType();
            if (type != null) {
                variables.add(new Variable(local, checked(type)));
            }
        }
        int passed = Type.getArgumentTypes(call.desc).length;
        passed += call.getOpcode() == Opcodes.INVOKESTATIC ? 0 : 1;
        if (frame.getStackSize() != passed) {
            throw refused(method, "computes with what the call gives");
        }
        int place = method.maxLocals;
        for (int i = 0; i < passed; i++) {
            Variable argument = new Variable(place, checked(frame.getStack(i).getType()));
            arguments.add(argument);
            place += argument.type().getSize();
        }
        variables.addAll(arguments);
    }

    /** The object of a method is passed to it again when it is called again. */
    private void requireObjectKept(boolean hasObject) {
        for (AbstractInsnNode each : method.instructions) {
            if (hasObject && each.getOpcode() == Opcodes.ASTORE && ((VarInsnNode) each).var == 0) {
                throw refused(method, "forgets its object");
            }
        }
    }

    private Type checked(Type type) {
        boolean known =
                type.getSort() == Type.INT
                        || type.getSort() == Type.LONG
                        || Variables.isObject(type) && !type.equals(ExactTypes.UNKNOWN.getType());
        if (!known) {
            throw refused(method, "has a variable that cannot be saved");
        }
        return type;
    }

    private void write() {
        LabelNode again = new LabelNode();
        InsnList code = method.instructions;
        code.insertBefore(call, pass(again));
        code.insert(call, leave());
        code.insert(enter(again));
    }

    private InsnList pass(LabelNode again) {
        InsnList code = new InsnList();
        for (Variable argument : reversed(arguments)) {
            code.add(argument.store());
        }
        code.add(again);
        arguments.forEach(argument -> code.add(argument.load()));
        return code;
    }

    private InsnList leave() {
        InsnList code = new InsnList();
        LabelNode stay = new LabelNode();
        code.add(to("rests", "()Z"));
        code.add(new JumpInsnNode(Opcodes.IFEQ, stay));
        int given = Type.getReturnType(call.desc).getSize();
        if (given > 0) {
            code.add(new InsnNode(given == 1 ? Opcodes.POP : Opcodes.POP2));
        }
        for (Variable variable : variables) {
            code.add(variable.load());
            code.add(to("save", "(" + general(variable.type()) + ")V"));
        }
        if (isOutermost) {
            code.add(new VarInsnNode(Opcodes.ALOAD, 0));
            code.add(to("save", "(" + OBJECT + ")V"));
        }
        code.add(nothing());
        code.add(new InsnNode(Type.getReturnType(method.desc).getOpcode(Opcodes.IRETURN)));
        code.add(stay);
        return code;
    }

    /** What is returned does not matter. */
    private InsnList nothing() {
        InsnList code = new InsnList();
        switch (Type.getReturnType(method.desc).getSort()) {
            case Type.VOID -> {}
            case Type.BOOLEAN, Type.INT -> code.add(new InsnNode(Opcodes.ICONST_0));
            default -> throw refused(method, "returns what is no whole number");
        }
        return code;
    }

    private InsnList enter(LabelNode again) {
        InsnList code = new InsnList();
        LabelNode begin = new LabelNode();
        code.add(to("resumes", "()Z"));
        code.add(new JumpInsnNode(Opcodes.IFEQ, begin));
        for (Variable variable : reversed(variables)) {
            code.add(take(variable.type()));
            code.add(variable.store());
        }
        code.add(new JumpInsnNode(Opcodes.GOTO, again));
        code.add(begin);
        return code;
    }

    private static InsnList take(Type type) {
        InsnList code = new InsnList();
        switch (type.getSort()) {
            case Type.INT -> code.add(to("takeInt", "()I"));
            case Type.LONG -> code.add(to("takeLong", "()J"));
            default -> {
                code.add(to("takeObject", "()" + OBJECT));
                code.add(
                        ExactTypes.isNull(new BasicValue(type))
                                ? asNull()
                                : only(
                                        new TypeInsnNode(
                                                Opcodes.CHECKCAST, type.getInternalName())));
            }
        }
        return code;
    }

    private static InsnList asNull() {
        InsnList code = only(new InsnNode(Opcodes.POP));
        code.add(new InsnNode(Opcodes.ACONST_NULL));
        return code;
    }

    private static InsnList only(AbstractInsnNode instruction) {
        InsnList code = new InsnList();
        code.add(instruction);
        return code;
    }

    private static String general(Type type) {
        return Variables.isObject(type) ? OBJECT : type.getDescriptor();
    }

    private static MethodInsnNode to(String name, String descriptor) {
        return new MethodInsnNode(Opcodes.INVOKESTATIC, RESTS, name, descriptor, false);
    }

    private static List<Variable> reversed(List<Variable> variables) {
        List<Variable> reversed = new ArrayList<>(variables);
        Collections.reverse(reversed);
        return reversed;
    }
}
