package arcomat.brick;

import arcomat.source.Diagnostic;

import org.objectweb.asm.tree.AbstractInsnNode;
import org.objectweb.asm.tree.LdcInsnNode;
import org.objectweb.asm.tree.MethodNode;

import java.util.Arrays;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.stream.Stream;

/** ARC0915: the display draws ASCII; for any other letter the old one stays on it (measured). */
final class DisplayLetters implements BrickLaw {
    @Override
    public String code() {
        return "ARC0915";
    }

    @Override
    public Stream<Diagnostic> findings(Program program) {
        return program.inClasses(
                (file, node) -> node.methods.stream().flatMap(method -> inMethod(file, method)));
    }

    private Stream<Diagnostic> inMethod(ClassFile file, MethodNode method) {
        return Arrays.stream(method.instructions.toArray())
                .filter(each -> each instanceof LdcInsnNode text && text.cst instanceof String)
                .flatMap(each -> inText(file, method, each).stream());
    }

    private Optional<Diagnostic> inText(ClassFile file, MethodNode method, AbstractInsnNode each) {
        String text = (String) ((LdcInsnNode) each).cst;
        OptionalInt strange = text.codePoints().filter(DisplayLetters::isStrange).findFirst();
        return strange.stream()
                .mapToObj(
                        letter ->
                                Diagnostic.warning(
                                        code(),
                                        file.span(method, each),
                                        "%s has a text with '%s', which the brick's display cannot show; use the letters of ASCII"
                                                .formatted(
                                                        file.where(method, each),
                                                        Character.toString(letter))))
                .findFirst();
    }

    /** Control characters are for other purposes than to be seen. */
    private static boolean isStrange(int letter) {
        return letter > '~';
    }
}
