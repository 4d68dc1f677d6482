package arcomat.live.pack;

import org.teavm.model.BasicBlock;
import org.teavm.model.ClassHierarchy;
import org.teavm.model.ClassHolder;
import org.teavm.model.ClassHolderTransformer;
import org.teavm.model.ClassHolderTransformerContext;
import org.teavm.model.ClassReader;
import org.teavm.model.ElementModifier;
import org.teavm.model.Instruction;
import org.teavm.model.MethodHolder;
import org.teavm.model.Program;
import org.teavm.model.ValueType;
import org.teavm.model.instructions.CastInstruction;

/**
 * Believes casts to interfaces, nearly all of which Java's compiler has put in for generic types.
 * To try one means to look into a table of what a class implements; that was a tenth of a check.
 * What is not of the interface does not have its methods either: there is no answer then, as
 * before, but an error at the first call. Casts to classes are tried.
 */
public final class BelievedCasts implements ClassHolderTransformer {
    @Override
    public void transformClass(ClassHolder type, ClassHolderTransformerContext context) {
        for (MethodHolder method : type.getMethods()) {
            Program program = method.getProgram();
            if (program != null) {
                program.getBasicBlocks().forEach(each -> believe(each, context.getHierarchy()));
            }
        }
    }

    private static void believe(BasicBlock block, ClassHierarchy hierarchy) {
        for (Instruction each : block) {
            if (each instanceof CastInstruction cast
                    && isInterface(cast.getTargetType(), hierarchy)) {
                cast.setWeak(true);
            }
        }
    }

    private static boolean isInterface(ValueType type, ClassHierarchy hierarchy) {
        if (!(type instanceof ValueType.Object object)) {
            return false;
        }
        ClassReader target = hierarchy.getClassSource().get(object.getClassName());
        return target != null && target.hasModifier(ElementModifier.INTERFACE);
    }
}
