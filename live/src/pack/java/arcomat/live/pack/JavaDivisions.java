package arcomat.live.pack;

import org.teavm.model.BasicBlock;
import org.teavm.model.ClassHolder;
import org.teavm.model.ClassHolderTransformer;
import org.teavm.model.ClassHolderTransformerContext;
import org.teavm.model.Instruction;
import org.teavm.model.MethodHolder;
import org.teavm.model.MethodReference;
import org.teavm.model.Program;
import org.teavm.model.ValueType;
import org.teavm.model.instructions.BinaryInstruction;
import org.teavm.model.instructions.BinaryOperation;
import org.teavm.model.instructions.InvocationType;
import org.teavm.model.instructions.InvokeInstruction;
import org.teavm.model.instructions.NumericOperandType;

/**
 * Has whole numbers divided as Java says. TeaVM leaves that to WebAssembly, which ends everything
 * where the divisor is 0 and where the least number is divided by -1.
 */
public final class JavaDivisions implements ClassHolderTransformer {
    private static final String DIVISION = "arcomat.live.browser.Division";

    @Override
    public void transformClass(ClassHolder type, ClassHolderTransformerContext context) {
        if (type.getName().equals(DIVISION)) {
            return;
        }
        for (MethodHolder method : type.getMethods()) {
            Program program = method.getProgram();
            if (program != null) {
                program.getBasicBlocks().forEach(JavaDivisions::divide);
            }
        }
    }

    private static void divide(BasicBlock block) {
        for (Instruction each : block) {
            if (each instanceof BinaryInstruction binary && isWhole(binary.getOperandType())) {
                if (binary.getOperation() == BinaryOperation.DIVIDE) {
                    binary.replace(call("quotient", binary));
                } else if (binary.getOperation() == BinaryOperation.MODULO) {
                    binary.replace(call("remainder", binary));
                }
            }
        }
    }

    private static boolean isWhole(NumericOperandType type) {
        return type == NumericOperandType.INT || type == NumericOperandType.LONG;
    }

    private static Instruction call(String method, BinaryInstruction binary) {
        ValueType type =
                binary.getOperandType() == NumericOperandType.INT
                        ? ValueType.INTEGER
                        : ValueType.LONG;
        InvokeInstruction call = new InvokeInstruction();
        call.setType(InvocationType.SPECIAL);
        call.setMethod(new MethodReference(DIVISION, method, type, type, type));
        call.setArguments(binary.getFirstOperand(), binary.getSecondOperand());
        call.setReceiver(binary.getReceiver());
        call.setLocation(binary.getLocation());
        return call;
    }
}
