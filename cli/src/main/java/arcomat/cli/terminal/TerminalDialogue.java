package arcomat.cli.terminal;

import arcomat.model.Letter;
import arcomat.pipeline.simulate.Decider;
import arcomat.report.text.Printable;
import arcomat.simulate.run.Question;

import java.io.IOException;
import java.io.PrintWriter;
import java.util.List;
import java.util.stream.Collectors;

/** Asks somebody at a terminal; numbers count from 1, an empty answer takes the first. */
public final class TerminalDialogue implements Decider.Dialogue {
    /** The input ended where an answer was needed. */
    public static final class NoAnswer extends RuntimeException {
        private static final long serialVersionUID = 1L;

        NoAnswer() {
            super("--choose ask needs an answer, and there is no more input");
        }
    }

    private final Console console;

    public TerminalDialogue(Console console) {
        this.console = console;
    }

    @Override
    public void stepBegins(int number, Letter inputs) {
        String messages =
                inputs.messages().entrySet().stream()
                        .map(port -> port.getKey() + " = " + text(port.getValue()))
                        .collect(Collectors.joining(", "));
        console.err()
                .println(
                        "%s: %s"
                                .formatted(
                                        number,
                                        messages.isEmpty()
                                                ? "no input"
                                                : Printable.escape(messages)));
    }

    private static String text(List<?> values) {
        return values.stream().map(Object::toString).collect(Collectors.joining(", "));
    }

    @Override
    public int ask(Question question) {
        PrintWriter err = console.err();
        err.println(
                "  %swhat happens?"
                        .formatted(
                                question.instance().isEmpty() ? "" : question.instance() + ": "));
        int number = 1;
        for (String alternative : question.alternatives()) {
            err.println("    " + number++ + "  " + Printable.escape(alternative));
        }
        while (true) {
            err.print("  1-" + question.count() + "> ");
            err.flush();
            int answer = answer(question.count());
            if (answer >= 0) {
                return answer;
            }
        }
    }

    /** The alternative from 0, or -1 for an answer that is none. */
    private int answer(int count) {
        try {
            String line = console.in().readLine();
            if (line == null) {
                throw new NoAnswer();
            }
            if (line.isBlank()) {
                return 0;
            }
            int number = Integer.parseInt(line.strip());
            return number >= 1 && number <= count ? number - 1 : -1;
        } catch (NumberFormatException e) {
            return -1;
        } catch (IOException e) {
            throw new NoAnswer();
        }
    }
}
