package arcomat.brick;

import arcomat.source.Diagnostic;

import org.objectweb.asm.tree.InvokeDynamicInsnNode;
import org.objectweb.asm.tree.MethodNode;

import java.util.stream.Stream;

/** ARC0902: the linker does not know invokedynamic, to which later compilers turn many things. */
final class NoInvokeDynamic implements BrickLaw {
    @Override
    public String code() {
        return "ARC0902";
    }

    @Override
    public Stream<Diagnostic> findings(Program program) {
        return program.inInstructions(
                InvokeDynamicInsnNode.class,
                (file, method, each) -> Stream.of(finding(file, method, each)));
    }

    private Diagnostic finding(ClassFile file, MethodNode method, InvokeDynamicInsnNode each) {
        return Diagnostic.error(
                code(),
                file.span(method, each),
                file.where(method, each)
                        + " uses invokedynamic ("
                        + cause(each)
                        + "), which cannot be linked for the brick; write plain Java 6");
    }

    private static String cause(InvokeDynamicInsnNode instruction) {
        String factory = Names.simple(instruction.bsm.getOwner());
        return switch (factory) {
            case "LambdaMetafactory" -> "a lambda or method reference";
            case "StringConcatFactory" -> "texts joined by +, compiled for Java 9 or later";
            default -> factory;
        };
    }
}
