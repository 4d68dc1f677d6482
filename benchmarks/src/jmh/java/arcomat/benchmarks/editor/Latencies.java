package arcomat.benchmarks.editor;

import arcomat.benchmarks.measure.Measurement;
import arcomat.cli.Embedded;

import org.eclipse.lsp4j.CompletionParams;
import org.eclipse.lsp4j.HoverParams;
import org.eclipse.lsp4j.Position;
import org.eclipse.lsp4j.Range;
import org.eclipse.lsp4j.RenameParams;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.io.Writer;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * How long somebody waits at the editor, from the message to the answer. Nineteen of twenty times
 * it is at most the figure that counts.
 */
final class Latencies {
    static final String FULL = "full check";
    static final String START = "start";
    static final String KEY = "key";
    static final String KEY_OF_SHARED = "key in a part of 100";
    static final String COMPLETION = "completion";
    static final String HOVER = "hover";
    static final String RENAME = "rename in 100 files";
    static final String MEMORY = "memory";

    private static final int WARM_UP = 60;
    private static final int MEASURED = 100;
    private static final int STARTS = 5;
    private static final double SHARE = 0.95;
    private static final Path TOOL = Path.of("build/install/arcomat/bin/arcomat").toAbsolutePath();

    private final Workshop workshop;
    private final Map<String, Measurement> results = new TreeMap<>();

    private Latencies(Workshop workshop) {
        this.workshop = workshop;
    }

    static Map<String, Measurement> measure() throws IOException {
        try (Workshop workshop = new Workshop()) {
            Latencies latencies = new Latencies(workshop);
            latencies.fullChecks();
            latencies.starts();
            latencies.session();
            return latencies.results;
        }
    }

    private interface Work {
        void run() throws IOException;
    }

    private static double milliseconds(Work work) throws IOException {
        long begun = System.nanoTime();
        work.run();
        return (System.nanoTime() - begun) / 1e6;
    }

    /** By the tool in a process that is warm. */
    private void fullChecks() throws IOException {
        List<Double> times = new ArrayList<>();
        for (int i = 0; i < 2 * STARTS; i++) {
            double time = milliseconds(this::check);
            if (i >= STARTS) {
                times.add(time);
            }
        }
        add(FULL, times);
    }

    private void check() {
        StringWriter err = new StringWriter();
        int status;
        try {
            status =
                    Embedded.run(
                            workshop.folder(),
                            new PrintWriter(Writer.nullWriter()),
                            new PrintWriter(err),
                            "check",
                            ".");
        } catch (InterruptedException e) {
            throw new IllegalStateException(e);
        }
        if (status != 0) {
            throw new IllegalStateException(err.toString());
        }
    }

    /** From nothing to the first findings. */
    private void starts() throws IOException {
        String broken = workshop.text(Workshop.USER).replace("component Line50", "component Other");
        List<Double> times = new ArrayList<>();
        for (int i = 0; i < STARTS; i++) {
            long begun = System.nanoTime();
            try (ServedEditor editor = new ServedEditor(TOOL, workshop.folder())) {
                editor.open(Workshop.USER, broken);
                editor.awaitFindings(Workshop.USER);
                times.add((System.nanoTime() - begun) / 1e6);
            }
        }
        add(START, times);
    }

    private void session() throws IOException {
        try (ServedEditor editor = new ServedEditor(TOOL, workshop.folder())) {
            for (String path : List.of(Workshop.USER, Workshop.CONTROLLER, Workshop.SHARED)) {
                editor.open(path, workshop.text(path));
            }
            keys(editor, KEY, Workshop.CONTROLLER);
            keys(editor, KEY_OF_SHARED, Workshop.SHARED);
            asked(COMPLETION, () -> complete(editor));
            if (editor.hovers()) {
                asked(HOVER, () -> hover(editor));
            }
            asked(RENAME, () -> rename(editor));
            results.put(MEMORY, new Measurement(MEMORY, editor.megabytes(), 0, 0, "MB"));
        }
    }

    /** A letter too many in the first line, and its removal; both change what is found. */
    private void keys(ServedEditor editor, String label, String path) throws IOException {
        List<Double> times = new ArrayList<>();
        for (int i = 0; i < WARM_UP + MEASURED; i++) {
            boolean breaks = i % 2 == 0;
            Range range = new Range(new Position(0, 7), new Position(0, breaks ? 7 : 8));
            double time =
                    milliseconds(
                            () -> {
                                editor.replace(path, range, breaks ? ";" : "");
                                editor.awaitFindings(path);
                            });
            if (i >= WARM_UP) {
                times.add(time);
            }
        }
        add(label, times);
    }

    private void asked(String label, Work work) throws IOException {
        List<Double> times = new ArrayList<>();
        for (int i = 0; i < WARM_UP + MEASURED; i++) {
            double time = milliseconds(work);
            if (i >= WARM_UP) {
                times.add(time);
            }
        }
        add(label, times);
    }

    /** A receiver behind a sender. */
    private void complete(ServedEditor editor) throws IOException {
        var params =
                new CompletionParams(editor.document(Workshop.USER), place("clock.late -> ", 14));
        if (ServedEditor.get(editor.documents().completion(params)).getLeft().isEmpty()) {
            throw new IllegalStateException("nothing is proposed");
        }
    }

    private void hover(ServedEditor editor) throws IOException {
        var params = new HoverParams(editor.document(Workshop.USER), place("clock.late", 7));
        if (ServedEditor.get(editor.documents().hover(params)) == null) {
            throw new IllegalStateException("nothing is told");
        }
    }

    private void rename(ServedEditor editor) throws IOException {
        var params =
                new RenameParams(editor.document(Workshop.USER), place("clock.late", 7), "overdue");
        var edit = ServedEditor.get(editor.documents().rename(params));
        int files = edit.getChanges().size();
        if (files < 100) {
            throw new IllegalStateException("renamed in " + files + " files");
        }
    }

    private Position place(String words, int letters) throws IOException {
        List<String> lines = workshop.text(Workshop.USER).lines().toList();
        for (int line = 0; line < lines.size(); line++) {
            int at = lines.get(line).indexOf(words);
            if (at >= 0) {
                return new Position(line, at + letters);
            }
        }
        throw new IllegalArgumentException(words);
    }

    /** The figure is what nineteen of twenty stay below; quartiles are those of all. */
    private void add(String label, List<Double> times) {
        Collections.sort(times);
        results.put(
                label,
                new Measurement(
                        label,
                        times.get((int) Math.ceil(SHARE * times.size()) - 1),
                        times.get(times.size() / 4),
                        times.get(times.size() * 3 / 4),
                        "ms"));
    }
}
