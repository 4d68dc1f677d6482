package arcomat.brick;

import arcomat.source.Diagnostic;

import org.objectweb.asm.tree.MethodNode;

import java.util.stream.Stream;

/** ARC0907: the brick has one byte for the number of a method's local variables. */
final class LocalLimit implements BrickLaw {
    private static final int LOCALS = 255;

    @Override
    public String code() {
        return "ARC0907";
    }

    @Override
    public Stream<Diagnostic> findings(Program program) {
        return program.inClasses(
                (file, node) ->
                        node.methods.stream()
                                .filter(method -> method.maxLocals > LOCALS)
                                .map(method -> finding(file, method)));
    }

    private Diagnostic finding(ClassFile file, MethodNode method) {
        return Diagnostic.error(
                code(),
                file.span(method),
                Limit.message(
                        file.where(method),
                        method.maxLocals,
                        "words of local variables",
                        LOCALS,
                        "divide it into several methods"));
    }
}
