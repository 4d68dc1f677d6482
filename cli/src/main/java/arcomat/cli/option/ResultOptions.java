package arcomat.cli.option;

import arcomat.cli.terminal.Console;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.file.AtomicFile;
import arcomat.pipeline.guest.RenderForm;
import arcomat.pipeline.guest.RenderForm.Rendered;
import arcomat.report.text.Style;

import picocli.CommandLine.Option;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.Iterator;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/** How a command writes its result: to the console in one format, to files in any. */
abstract class ResultOptions {
    /** The formats of the tool, for completion; what guests bring is known when they are there. */
    static final class Own implements Iterable<String> {
        @Override
        public Iterator<String> iterator() {
            return ReportFormat.names().iterator();
        }
    }

    @Option(
            names = "--format",
            paramLabel = "FORMAT",
            defaultValue = "text",
            completionCandidates = Own.class,
            description = "How to write results: ${COMPLETION-CANDIDATES}; default text.")
    private String format;

    /** What is to be written beside what is printed. */
    abstract List<ReportFile> files();

    /** Complains before any work is done in vain. */
    public void prepare(Session session) throws WrongUse {
        List<String> known = new ArrayList<>(ReportFormat.names());
        known.addAll(RenderForm.known(session));
        List<String> asked = new ArrayList<>(List.of(format));
        files().forEach(each -> each.format().ifPresent(asked::add));
        for (String name : asked) {
            if (!known.contains(name)) {
                throw new WrongUse(
                        "there is no format '%s', only %s", name, String.join(", ", known));
            }
        }
        refuseFileOfTwo();
    }

    /**
     * Writes the files first: they are complete when the console says what happened. What a guest
     * cannot write is told at the end, so that nothing else is lost by that.
     */
    public final void write(CommandResults results, Session session, Console console)
            throws WrongUse {
        List<String> problems = new ArrayList<>();
        for (ReportFile each : files()) {
            if (each.format().isPresent()) {
                Rendered text = text(each.format().get(), Style.PLAIN, results, session);
                if (text.text().isPresent()) {
                    AtomicFile.write(each.file(), text.text().get(), session.names());
                } else {
                    problems.add(text.problem());
                }
            }
        }
        Rendered shown = text(format, console.style(), results, session);
        console.out()
                .print(
                        shown.text()
                                .orElseGet(
                                        () ->
                                                results.rendering()
                                                        .text(ReportFormat.text, console.style())));
        if (shown.text().isEmpty()) {
            problems.add(shown.problem());
        }
        if (!problems.isEmpty()) {
            throw new WrongUse("%s", problems.get(0));
        }
    }

    private static Rendered text(String name, Style style, CommandResults results, Session session)
            throws WrongUse {
        Optional<ReportFormat> own = ReportFormat.of(name);
        return own.isPresent()
                ? new Rendered(Optional.of(results.rendering().text(own.get(), style)), "")
                : session.run(new RenderForm(name, results.command(), results.findings().get()));
    }

    private void refuseFileOfTwo() throws WrongUse {
        Set<String> names = new HashSet<>();
        for (ReportFile each : files()) {
            if (!names.add(each.file())) {
                throw new WrongUse(
                        "two reports go to '%s'; give each a file of its own", each.file());
            }
        }
    }
}
