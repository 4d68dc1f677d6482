package arcomat.brick.need;

import arcomat.brick.need.flow.Constants;
import arcomat.brick.need.flow.MethodName;
import arcomat.brick.need.flow.Unknown;

import org.jspecify.annotations.Nullable;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.Type;
import org.objectweb.asm.tree.AbstractInsnNode;
import org.objectweb.asm.tree.IincInsnNode;
import org.objectweb.asm.tree.MethodNode;
import org.objectweb.asm.tree.analysis.Analyzer;
import org.objectweb.asm.tree.analysis.AnalyzerException;
import org.objectweb.asm.tree.analysis.BasicInterpreter;
import org.objectweb.asm.tree.analysis.BasicValue;
import org.objectweb.asm.tree.analysis.BasicVerifier;
import org.objectweb.asm.tree.analysis.Frame;

import java.util.Optional;
import java.util.OptionalInt;

/** Calculates with numbers that are known; of all other results nothing is. */
final class Operations extends BasicInterpreter {
    private static final Operations ALL = new Operations();

    private Operations() {
        super(ASM9);
    }

    /** Any value of a type; null for none. */
    static @Nullable BasicValue unknown(Type type) {
        return ALL.newValue(type);
    }

    /**
     * Looks whether each instruction finds its operands, as a virtual machine does that loads them.
     *
     * @throws Unknown if one does not
     */
    static void verify(MethodName name, MethodNode method) {
        try {
            new Analyzer<>(new BasicVerifier()).analyze(name.owner(), method);
        } catch (AnalyzerException | IndexOutOfBoundsException e) {
            throw Unknown.of(name, "is no method that can run");
        }
    }

    /** Carries out an instruction that neither jumps nor calls, on locals and stack. */
    static void execute(AbstractInsnNode instruction, Frame<BasicValue> frame) {
        try {
            frame.execute(instruction, ALL);
        } catch (AnalyzerException e) {
            throw new Unknown("an instruction has operands of another kind");
        }
    }

    @Override
    public BasicValue newOperation(AbstractInsnNode instruction) throws AnalyzerException {
        if (instruction.getOpcode() == Opcodes.ACONST_NULL) {
            return KnownValue.NULL;
        }
        OptionalInt pushed = Constants.pushed(instruction);
        return pushed.isPresent()
                ? KnownValue.number(pushed.getAsInt())
                : super.newOperation(instruction);
    }

    @Override
    public BasicValue unaryOperation(AbstractInsnNode instruction, BasicValue value)
            throws AnalyzerException {
        if (instruction.getOpcode() == Opcodes.CHECKCAST) {
            return value;
        }
        if (!(value instanceof KnownValue known)) {
            return super.unaryOperation(instruction, value);
        }
        int number = known.number();
        return switch (instruction.getOpcode()) {
            case Opcodes.INEG -> KnownValue.number(-number);
            case Opcodes.IINC -> KnownValue.number(number + ((IincInsnNode) instruction).incr);
            case Opcodes.I2B -> KnownValue.number((byte) number);
            case Opcodes.I2C -> KnownValue.number((char) number);
            case Opcodes.I2S -> KnownValue.number((short) number);
            default -> super.unaryOperation(instruction, value);
        };
    }

    @Override
    public BasicValue binaryOperation(AbstractInsnNode instruction, BasicValue a, BasicValue b)
            throws AnalyzerException {
        if (!(a instanceof KnownValue left) || !(b instanceof KnownValue right)) {
            return super.binaryOperation(instruction, a, b);
        }
        int x = left.number();
        int y = right.number();
        return switch (instruction.getOpcode()) {
            case Opcodes.IADD -> KnownValue.number(x + y);
            case Opcodes.ISUB -> KnownValue.number(x - y);
            case Opcodes.IMUL -> KnownValue.number(x * y);
            case Opcodes.IAND -> KnownValue.number(x & y);
            case Opcodes.IOR -> KnownValue.number(x | y);
            case Opcodes.IXOR -> KnownValue.number(x ^ y);
            default -> super.binaryOperation(instruction, a, b);
        };
    }

    /**
     * Whether a jump with a condition is taken, as far as that is known.
     *
     * @param first the same as the second, where only one value is looked at
     */
    static Optional<Boolean> isTaken(int opcode, BasicValue first, BasicValue second) {
        return first instanceof KnownValue a && second instanceof KnownValue b
                ? Optional.of(isTaken(opcode, a.number(), b.number()))
                : Optional.empty();
    }

    private static boolean isTaken(int opcode, int x, int y) {
        return switch (opcode) {
            case Opcodes.IFEQ -> y == 0;
            case Opcodes.IFNE -> y != 0;
            case Opcodes.IFLT -> y < 0;
            case Opcodes.IFGE -> y >= 0;
            case Opcodes.IFGT -> y > 0;
            case Opcodes.IFLE -> y <= 0;
            case Opcodes.IFNULL -> y == KnownValue.NULL.number();
            case Opcodes.IFNONNULL -> y != KnownValue.NULL.number();
            case Opcodes.IF_ICMPEQ, Opcodes.IF_ACMPEQ -> x == y;
            case Opcodes.IF_ICMPNE, Opcodes.IF_ACMPNE -> x != y;
            case Opcodes.IF_ICMPLT -> x < y;
            case Opcodes.IF_ICMPGE -> x >= y;
            case Opcodes.IF_ICMPGT -> x > y;
            default -> x <= y;
        };
    }
}
