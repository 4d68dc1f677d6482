package arcomat.brick;

import arcomat.source.Diagnostic;

import java.util.stream.Stream;

/** ARC0905: the brick numbers the methods of a class with one byte. */
final class MethodLimit implements BrickLaw {
    private static final int METHODS = 255;

    @Override
    public String code() {
        return "ARC0905";
    }

    @Override
    public Stream<Diagnostic> findings(Program program) {
        return program.files().stream()
                .filter(file -> file.methods() > METHODS)
                .map(file -> Diagnostic.error(code(), file.span(), message(file)));
    }

    private static String message(ClassFile file) {
        return Limit.message(
                file.name(), file.methods(), "methods", METHODS, "divide it into several classes");
    }
}
