package arcomat.brick;

import arcomat.source.Diagnostic;

import org.objectweb.asm.Opcodes;
import org.objectweb.asm.tree.ClassNode;

import java.util.stream.Stream;

/** ARC0906: the brick numbers the fields of an object that a class declares with one byte. */
final class FieldLimit implements BrickLaw {
    private static final int FIELDS = 255;

    @Override
    public String code() {
        return "ARC0906";
    }

    @Override
    public Stream<Diagnostic> findings(Program program) {
        return program.inClasses(
                (file, node) ->
                        fields(node) > FIELDS
                                ? Stream.of(finding(file, fields(node)))
                                : Stream.empty());
    }

    private static int fields(ClassNode node) {
        return (int) node.fields.stream().filter(f -> (f.access & Opcodes.ACC_STATIC) == 0).count();
    }

    private Diagnostic finding(ClassFile file, int fields) {
        return Diagnostic.error(
                code(),
                file.span(),
                Limit.message(
                        file.name(), fields, "fields", FIELDS, "divide it into several classes"));
    }
}
