package arcomat.lower.statements;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;

/**
 * Statements with what they do.
 *
 * @param lines as models write them
 */
record Program(List<String> lines, Consumer<Frame> run) {

    /** The transition cannot be taken: something is not there. */
    static final class NotEnabled extends RuntimeException {
        private static final long serialVersionUID = 1;
    }

    static Program sequence(List<Program> programs) {
        List<String> lines = new ArrayList<>();
        programs.forEach(each -> lines.addAll(each.lines));
        return new Program(lines, frame -> programs.forEach(each -> each.run.accept(frame)));
    }

    static Program assign(String name, Term value) {
        return new Program(
                List.of(name + " = " + value.text() + ";"),
                frame -> frame.assign(name, value.in(frame)));
    }

    static Program local(String type, String name, Term value) {
        return new Program(
                List.of(type + " " + name + " = " + value.text() + ";"),
                frame -> frame.assign(name, value.in(frame)));
    }

    static Program changed(String name, Term amount, boolean up) {
        Term sum =
                Term.calculated(
                        Term.name(name), up ? "+" : "-", amount, (a, b) -> up ? a + b : a - b);
        return new Program(
                List.of(name + (up ? " += " : " -= ") + amount.text() + ";"),
                frame -> frame.assign(name, sum.in(frame)));
    }

    static Program stepped(String name, boolean up) {
        return new Program(
                List.of(name + (up ? "++;" : "--;")), changed(name, Term.constant(1), up).run);
    }

    static Program send(String port, Term value) {
        return new Program(
                List.of(port + " = " + value.text() + ";"),
                frame -> frame.sent.put(port, Optional.of(value.in(frame))));
    }

    static Program silence(String port, String sign) {
        return new Program(
                List.of(port + " = " + sign + ";"),
                frame -> frame.sent.put(port, Optional.empty()));
    }

    static Program choice(Term condition, Program then, Program otherwise) {
        List<String> lines = new ArrayList<>();
        lines.add("if (" + condition.text() + ") {");
        lines.addAll(then.lines);
        lines.add(otherwise.lines.isEmpty() ? "}" : "} else {");
        if (!otherwise.lines.isEmpty()) {
            lines.addAll(otherwise.lines);
            lines.add("}");
        }
        return new Program(
                lines,
                frame -> {
                    boolean truth = condition.in(frame).truth().orElseThrow(NotEnabled::new);
                    (truth ? then : otherwise).run.accept(frame);
                });
    }
}
