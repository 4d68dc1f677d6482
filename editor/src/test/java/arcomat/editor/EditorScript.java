package arcomat.editor;

import org.eclipse.lsp4j.CodeAction;
import org.eclipse.lsp4j.CodeActionContext;
import org.eclipse.lsp4j.Command;
import org.eclipse.lsp4j.CompletionItem;
import org.eclipse.lsp4j.CompletionParams;
import org.eclipse.lsp4j.Diagnostic;
import org.eclipse.lsp4j.DiagnosticSeverity;
import org.eclipse.lsp4j.DocumentFormattingParams;
import org.eclipse.lsp4j.DocumentRangeFormattingParams;
import org.eclipse.lsp4j.FormattingOptions;
import org.eclipse.lsp4j.Position;
import org.eclipse.lsp4j.Range;
import org.eclipse.lsp4j.jsonrpc.messages.Either;

import java.io.IOException;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;

/**
 * What somebody does in an editor, line by line, and what the editor shows. Positions are written
 * as in findings, line and column from 1: {@code 3:5}, {@code 3:5-4:1}.
 */
final class EditorScript {
    private final EditorClient client;

    EditorScript(EditorClient client) {
        this.client = client;
    }

    /** Does one step and returns what there is to see. */
    String run(String step) throws IOException {
        String[] words = step.split(" ", 4);
        String path = words.length > 1 ? words[1] : "";
        String place = words.length > 2 ? words[2] : "";
        String rest = words.length > 3 ? words[3] : "";
        return switch (words[0]) {
            case "open" -> silently(() -> client.open(path));
            case "close" -> silently(() -> client.close(path));
            case "show" -> client.text(path).text();
            case "type" -> silently(() -> client.replace(path, range(place), unescaped(rest)));
            case "problems" -> problems();
            case "libraries" -> silently(() -> client.refersTo(step.split(" ")));
            case "messages" -> String.join("\n", client.toldSince()) + "\n";
            case "complete" -> completions(path, range(place).getStart());
            case "accept" -> silently(() -> accept(path, range(place).getStart(), rest));
            case "fixes" -> fixes(path, range(place));
            case "offered" -> offered(path, range(place), rest);
            case "fix" -> silently(() -> fix(path, range(place), rest));
            case "fix-all" -> silently(() -> fixAll(path));
            case "format" -> silently(() -> format(path));
            case "format-range" -> silently(() -> format(path, range(place)));
            default -> otherwise(step, words[0], path, place, rest);
        };
    }

    private String otherwise(String step, String word, String path, String place, String rest)
            throws IOException {
        Optional<String> seen =
                new NameSteps(client)
                        .run(word, path, place, rest)
                        .or(() -> new ShapeSteps(client).run(word, path, place))
                        .or(() -> new FactSteps(client).run(word, path, place));
        return (seen.isPresent() ? seen : new VerdictSteps(client).run(word, path, place))
                .orElseThrow(() -> new AssertionError("no step: " + step));
    }

    private interface Action {
        void run() throws IOException;
    }

    private static String silently(Action action) throws IOException {
        action.run();
        return "";
    }

    private String problems() {
        StringBuilder text = new StringBuilder();
        client.problems()
                .forEach((path, found) -> found.forEach(each -> text.append(line(path, each))));
        return text.toString();
    }

    private static String line(String path, Diagnostic problem) {
        return "%s:%s %s %s: %s\n"
                .formatted(
                        path,
                        written(problem.getRange()),
                        problem.getSeverity() == DiagnosticSeverity.Error ? "error" : "warning",
                        problem.getCode().getLeft(),
                        problem.getMessage().getLeft());
    }

    private List<CompletionItem> proposals(String path, Position position) {
        var params = new CompletionParams(client.document(path), position);
        return EditorClient.get(client.server().getTextDocumentService().completion(params))
                .getLeft();
    }

    private String completions(String path, Position position) {
        return proposals(path, position).stream()
                .map(each -> "%s (%s)\n".formatted(each.getLabel(), what(each)))
                .collect(Collectors.joining());
    }

    private static String what(CompletionItem item) {
        return item.getDetail() == null ? "keyword" : item.getDetail();
    }

    /** The edits that a proposal needs elsewhere are further up in the text. */
    private void accept(String path, Position position, String label) {
        for (CompletionItem each : proposals(path, position)) {
            if (each.getLabel().equals(label)) {
                client.apply(path, List.of(each.getTextEdit().getLeft()));
                if (each.getAdditionalTextEdits() != null) {
                    client.apply(path, each.getAdditionalTextEdits());
                }
                return;
            }
        }
        throw new AssertionError("no proposal '" + label + "'");
    }

    private String fixes(String path, Range range) {
        return titles(client.actions(path, range, List.of("quickfix")));
    }

    /** What is offered for the findings of a code, wherever in the range they are. */
    private String offered(String path, Range range, String code) {
        List<Diagnostic> shown =
                client.problems().getOrDefault(path, List.of()).stream()
                        .filter(each -> each.getCode().getLeft().equals(code))
                        .toList();
        return titles(client.actions(path, range, new CodeActionContext(shown)));
    }

    private static String titles(List<Either<Command, CodeAction>> actions) {
        return actions.stream()
                .map(each -> each.getRight().getTitle() + "\n")
                .collect(Collectors.joining());
    }

    private void fix(String path, Range range, String title) throws IOException {
        for (var each : client.actions(path, range, List.of("quickfix"))) {
            if (each.getRight().getTitle().equals(title)) {
                client.apply(each.getRight().getEdit());
                return;
            }
        }
        throw new AssertionError("no fix '" + title + "' at " + written(range));
    }

    private void fixAll(String path) throws IOException {
        for (var each : client.actions(path, range("1:1"), List.of("source.fixAll"))) {
            client.apply(each.getRight().getEdit());
        }
    }

    private void format(String path) {
        var params = new DocumentFormattingParams(client.document(path), new FormattingOptions());
        client.apply(
                path,
                EditorClient.get(client.server().getTextDocumentService().formatting(params)));
    }

    private void format(String path, Range range) {
        var params =
                new DocumentRangeFormattingParams(
                        client.document(path), new FormattingOptions(), range);
        client.apply(
                path,
                EditorClient.get(client.server().getTextDocumentService().rangeFormatting(params)));
    }

    /** {@code 3:5} or {@code 3:5-4:1}. */
    static Range range(String written) {
        String[] ends = written.split("-");
        Position start = position(ends[0]);
        return new Range(start, ends.length > 1 ? position(ends[1]) : start);
    }

    static Position position(String written) {
        String[] parts = written.split(":");
        return new Position(Integer.parseInt(parts[0]) - 1, Integer.parseInt(parts[1]) - 1);
    }

    static String written(Range range) {
        return range.getStart().equals(range.getEnd())
                ? written(range.getStart())
                : written(range.getStart()) + "-" + written(range.getEnd());
    }

    private static String written(Position position) {
        return (position.getLine() + 1) + ":" + (position.getCharacter() + 1);
    }

    private static String unescaped(String text) {
        return text.replace("\\n", "\n");
    }
}
