package arcomat.fuzz.process;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.ObjectMapper;

import org.xml.sax.InputSource;
import org.xml.sax.SAXException;

import java.io.IOException;
import java.io.StringReader;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.regex.Pattern;

import javax.xml.parsers.DocumentBuilderFactory;
import javax.xml.parsers.ParserConfigurationException;

/** What every call has to keep, whatever it is given. */
final class Verdict {
    private static final double LONGEST_SECONDS = 10;
    private static final long SMALL_INPUT = 100_000;
    private static final int WRONG_USE = 2;
    private static final Pattern STACK_TRACE =
            Pattern.compile(
                    "(?m)^\\s+at [\\w.$/<>]+\\(.*\\)$|internal error|Exception in thread"
                            + "|^arcomat: null$|(?i)OutOfMemoryError|StackOverflowError");

    private final Input input;
    private final Call call;
    private final Outcome outcome;
    private final List<String> faults = new ArrayList<>();

    private Verdict(Input input, Call call, Outcome outcome) {
        this.input = input;
        this.call = call;
        this.outcome = outcome;
    }

    /**
     * What is wrong with a call, in words; nothing where all is well.
     *
     * @param before all files before the call
     * @param after all files after it
     */
    static List<String> faults(
            Input input,
            Call call,
            Outcome outcome,
            SortedMap<String, byte[]> before,
            SortedMap<String, byte[]> after) {
        Verdict verdict = new Verdict(input, call, outcome);
        verdict.ends();
        if (outcome.status().isPresent()) {
            verdict.says(outcome.status().get());
            verdict.writes(outcome.status().get(), before, after);
        }
        return verdict.faults;
    }

    private void ends() {
        if (outcome.status().isEmpty()) {
            faults.add("does not end, or ends without an exit status");
        } else if (outcome.seconds() > LONGEST_SECONDS && input.bytes() < SMALL_INPUT) {
            faults.add("takes %.1f s".formatted(outcome.seconds()));
        }
        if (STACK_TRACE.matcher(outcome.said()).find()) {
            faults.add("an error of the tool is told");
        }
        if (!outcome.stray().isBlank()) {
            faults.add("something is told past the tool's own streams");
        }
    }

    private void says(int status) {
        if (!call.statuses().contains(status)) {
            faults.add("exit status " + status);
        }
        boolean complains = outcome.err().startsWith("arcomat: ");
        if (status == 0 && complains) {
            faults.add("exit status 0 with a complaint");
        }
        if (status != 0 && outcome.out().isBlank() && outcome.err().isBlank()) {
            faults.add("exit status " + status + " without a word");
        }
        if (!complains && call.command().equals("check") && call.option("--format").isEmpty()) {
            boolean errors = outcome.out().contains(": error ARC");
            if (errors == (status == 0)) {
                faults.add("exit status " + status + (errors ? " with" : " without") + " errors");
            }
        }
        if (!complains && !outcome.out().isBlank()) {
            parses(status);
        }
    }

    /** What other programs are to read. */
    private void parses(int status) {
        String format = call.option("--format") + call.option("--trace");
        boolean refused = outcome.out().contains(": error ARC");
        if (format.matches("json|sarif") && !(refused && !isReport())) {
            parsesAsJson(outcome.out());
        }
        if (format.equals("junit") && isReport()) {
            parsesAsXml(outcome.out());
        }
    }

    /** Commands that tell errors in models in the format that is asked for. */
    private boolean isReport() {
        return List.of("check", "test", "verify", "gate").contains(call.command());
    }

    private void writes(
            int status, SortedMap<String, byte[]> before, SortedMap<String, byte[]> after) {
        for (Map.Entry<String, byte[]> file : after.entrySet()) {
            String path = file.getKey();
            if (!Arrays.equals(file.getValue(), before.get(path))) {
                if (!call.mayWrite(path)) {
                    faults.add("writes " + path);
                } else if (path.endsWith(".tmp") || path.contains(".arcomat-new")) {
                    faults.add("leaves " + path);
                } else if (status == WRONG_USE && call.command().equals("generate")) {
                    faults.add("refuses, and writes " + path);
                }
                if (path.endsWith(".sarif") || path.endsWith(".json")) {
                    parsesAsJson(new String(file.getValue()));
                } else if (path.endsWith(".xml")) {
                    parsesAsXml(new String(file.getValue()));
                }
            }
        }
        for (String path : before.keySet()) {
            if (!after.containsKey(path) && !call.mayWrite(path)) {
                faults.add("removes " + path);
            }
        }
        if (!OldOutput.isWhole(after) && !OldOutput.isSame(before, after)) {
            faults.add("leaves half of its output");
        }
    }

    private void parsesAsJson(String text) {
        try {
            new ObjectMapper().readTree(text);
        } catch (JsonProcessingException e) {
            faults.add("writes what is no JSON: " + e.getOriginalMessage());
        }
    }

    private void parsesAsXml(String text) {
        try {
            var builder = DocumentBuilderFactory.newInstance().newDocumentBuilder();
            builder.setErrorHandler(null);
            builder.parse(new InputSource(new StringReader(text)));
        } catch (SAXException e) {
            faults.add("writes what is no XML: " + e.getMessage());
        } catch (IOException | ParserConfigurationException e) {
            throw new IllegalStateException(e);
        }
    }
}
