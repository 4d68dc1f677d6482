package arcomat.brick.law;

import arcomat.brick.jar.RobotProgram;
import arcomat.source.Diagnostic;

import java.util.stream.Stream;

/** ARC0907: the brick has one byte for the number of a method's local variables. */
final class LocalLimit extends Limit {
    LocalLimit() {
        super("ARC0907", "words of local variables", 255, "divide it into several methods");
    }

    @Override
    public Stream<Diagnostic> findings(RobotProgram program) {
        return program.inClasses(
                (file, node) ->
                        node.methods.stream()
                                .filter(m -> isExceededBy(m.maxLocals))
                                .map(m -> excess(file.span(m), file.where(m), m.maxLocals)));
    }
}
