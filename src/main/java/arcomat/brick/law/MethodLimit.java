package arcomat.brick.law;

import arcomat.brick.jar.RobotProgram;
import arcomat.source.Diagnostic;

import java.util.stream.Stream;

/** ARC0905: the brick numbers the methods of a class with one byte. */
final class MethodLimit extends Limit {
    MethodLimit() {
        super("ARC0905", "methods", 255, "divide it into several classes");
    }

    @Override
    public Stream<Diagnostic> findings(RobotProgram program) {
        return program.files().stream()
                .filter(file -> isExceededBy(file.methods()))
                .map(file -> excess(file.span(), file.name(), file.methods()));
    }
}
