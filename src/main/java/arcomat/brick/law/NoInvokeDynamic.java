package arcomat.brick.law;

import arcomat.brick.jar.ClassFile;
import arcomat.brick.jar.JavaNames;
import arcomat.brick.jar.RobotProgram;
import arcomat.source.Diagnostic;

import org.objectweb.asm.tree.InvokeDynamicInsnNode;
import org.objectweb.asm.tree.MethodNode;

import java.util.stream.Stream;

/** ARC0902: the linker does not know invokedynamic, to which later compilers turn many things. */
final class NoInvokeDynamic extends BrickLaw {
    NoInvokeDynamic() {
        super("ARC0902");
    }

    @Override
    public Stream<Diagnostic> findings(RobotProgram program) {
        return program.inInstructions(
                InvokeDynamicInsnNode.class,
                (file, method, each) -> Stream.of(finding(file, method, each)));
    }

    private Diagnostic finding(ClassFile file, MethodNode method, InvokeDynamicInsnNode each) {
        return error(
                file.span(method, each),
                "%s uses invokedynamic (%s), which cannot be linked for the brick; write plain Java"
                        + " 6",
                file.where(method, each),
                cause(each));
    }

    private static String cause(InvokeDynamicInsnNode instruction) {
        String factory = JavaNames.simple(instruction.bsm.getOwner());
        return switch (factory) {
            case "LambdaMetafactory" -> "a lambda or method reference";
            case "StringConcatFactory" -> "texts joined by +, compiled for Java 9 or later";
            default -> factory;
        };
    }
}
