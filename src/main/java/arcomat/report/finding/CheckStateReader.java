package arcomat.report.finding;

import arcomat.report.finding.CheckState.File;
import arcomat.report.finding.CheckState.Names;
import arcomat.source.Diagnostic;
import arcomat.source.Fix;
import arcomat.source.Related;
import arcomat.source.Severity;
import arcomat.source.SourceFile;
import arcomat.source.Span;
import arcomat.source.Suppressed;
import arcomat.source.TextEdit;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonToken;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;

/** Reads what {@link CheckStateJson} wrote. */
public final class CheckStateReader {
    private final JsonParser json;
    private final Function<String, SourceFile> sources;

    private CheckStateReader(JsonParser json, Function<String, SourceFile> sources) {
        this.json = json;
        this.sources = sources;
    }

    /**
     * @param sources the files by their paths, for the places of findings
     * @return empty where the text is no state, or the state of another key
     */
    public static Optional<CheckState> read(
            String text, String key, Function<String, SourceFile> sources) {
        try (JsonParser json = new JsonFactory().createParser(text)) {
            return new CheckStateReader(json, sources).state(key);
        } catch (IOException damaged) {
            return Optional.empty();
        }
    }

    private Optional<CheckState> state(String key) throws IOException {
        expect(json.nextToken(), JsonToken.START_ARRAY);
        if (!string().equals(key)) {
            return Optional.empty();
        }
        Map<String, String> folders = new HashMap<>();
        start();
        while (more()) {
            folders.put(json.getText(), string());
        }
        List<File> files = new ArrayList<>();
        start();
        while (more()) {
            files.add(file());
        }
        expect(json.nextToken(), JsonToken.END_ARRAY);
        expect(json.nextToken(), null);
        return Optional.of(new CheckState(key, folders, files));
    }

    private File file() throws IOException {
        String path = string();
        String hash = string();
        boolean named = flag();
        List<String> needs = strings();
        Optional<Names> names = names();
        String mentions = string();
        List<Diagnostic> findings = new ArrayList<>();
        start();
        while (more()) {
            findings.add(finding());
        }
        List<Suppressed> suppressed = new ArrayList<>();
        start();
        while (more()) {
            suppressed.add(new Suppressed(finding(), string()));
        }
        end();
        Set<String> words = new LinkedHashSet<>(Arrays.asList(mentions.split(" ")));
        return new File(path, hash, named, needs, names, words, findings, suppressed);
    }

    private Optional<Names> names() throws IOException {
        if (json.nextToken() == JsonToken.VALUE_NULL) {
            return Optional.empty();
        }
        expect(json.currentToken(), JsonToken.START_ARRAY);
        String packageName = string();
        List<String> components = strings();
        String diagram = string();
        List<String> types = strings();
        end();
        Optional<String> diagramName = Optional.of(diagram).filter(name -> !name.isEmpty());
        return Optional.of(new Names(packageName, components, diagramName, types));
    }

    /** Behind the bracket that starts it. */
    private Diagnostic finding() throws IOException {
        expect(json.currentToken(), JsonToken.START_ARRAY);
        String code = string();
        Severity severity = flag() ? Severity.ERROR : Severity.WARNING;
        Span span = span(string());
        String message = string();
        List<Related> related = new ArrayList<>();
        start();
        while (more()) {
            related.add(new Related(span(json.getText()), string()));
        }
        Optional<Fix> fix = fix();
        end();
        return new Diagnostic(code, severity, span, message, related, fix);
    }

    private Optional<Fix> fix() throws IOException {
        if (json.nextToken() == JsonToken.VALUE_NULL) {
            return Optional.empty();
        }
        expect(json.currentToken(), JsonToken.START_ARRAY);
        String title = string();
        List<TextEdit> edits = new ArrayList<>();
        while (more()) {
            edits.add(new TextEdit(span(json.getText()), string()));
        }
        return Optional.of(new Fix(title, edits));
    }

    private Span span(String path) throws IOException {
        return new Span(sources.apply(path), number(), number());
    }

    private List<String> strings() throws IOException {
        List<String> strings = new ArrayList<>();
        start();
        while (more()) {
            strings.add(json.getText());
        }
        return strings;
    }

    private String string() throws IOException {
        expect(json.nextToken(), JsonToken.VALUE_STRING);
        return json.getText();
    }

    private boolean flag() throws IOException {
        json.nextToken();
        return json.getBooleanValue();
    }

    private int number() throws IOException {
        expect(json.nextToken(), JsonToken.VALUE_NUMBER_INT);
        return json.getIntValue();
    }

    private void start() throws IOException {
        expect(json.nextToken(), JsonToken.START_ARRAY);
    }

    private void end() throws IOException {
        expect(json.nextToken(), JsonToken.END_ARRAY);
    }

    /** Goes on to the next value of an array, if there is one. */
    private boolean more() throws IOException {
        JsonToken next = json.nextToken();
        if (next == null) {
            throw new IOException("the text ends too early");
        }
        return next != JsonToken.END_ARRAY;
    }

    private static void expect(JsonToken found, JsonToken wanted) throws IOException {
        if (found != wanted) {
            throw new IOException("damaged");
        }
    }
}
