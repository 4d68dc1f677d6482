package arcomat.editor;

import org.eclipse.lsp4j.CodeLens;
import org.eclipse.lsp4j.CodeLensParams;
import org.eclipse.lsp4j.Command;
import org.eclipse.lsp4j.ExecuteCommandParams;
import org.eclipse.lsp4j.Position;
import org.eclipse.lsp4j.jsonrpc.ResponseErrorException;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/** Steps of a script that are about verdicts in the text. */
final class VerdictSteps {
    private static final Duration PATIENCE = Duration.ofSeconds(120);
    private static final String UNDER_WAY = "being asked";
    private static final String RUN = "run";
    private static final long MILLISECONDS_BETWEEN = 20;
    private static final Pattern TITLE = Pattern.compile("<title>(.*?)</title>", Pattern.DOTALL);

    private final EditorClient client;

    VerdictSteps(EditorClient client) {
        this.client = client;
    }

    /** What there is to see, or nothing where the step is none of these. */
    Optional<String> run(String step, String path, String place) throws IOException {
        return switch (step) {
            case "verdicts" -> Optional.of(written(settled(path)));
            case "verdicts-at-once" -> Optional.of(written(lenses(path)));
            case "look" -> Optional.of(look(path, EditorScript.position(place)));
            case "run" -> Optional.of(runAgain(path, EditorScript.position(place)));
            default -> Optional.empty();
        };
    }

    private List<? extends CodeLens> lenses(String path) {
        return EditorClient.get(
                client.server()
                        .getTextDocumentService()
                        .codeLens(new CodeLensParams(client.document(path))));
    }

    /** Once nothing is asked any longer. */
    List<? extends CodeLens> settled(String path) {
        long end = System.nanoTime() + PATIENCE.toNanos();
        while (System.nanoTime() < end) {
            List<? extends CodeLens> lenses = lenses(path);
            if (lenses.stream().noneMatch(each -> title(each).contains(UNDER_WAY))) {
                return lenses;
            }
            pause();
        }
        throw new AssertionError("no answers: " + written(lenses(path)));
    }

    private static void pause() {
        try {
            Thread.sleep(MILLISECONDS_BETWEEN);
        } catch (InterruptedException e) {
            throw new AssertionError(e);
        }
    }

    static String title(CodeLens lens) {
        return lens.getCommand().getTitle();
    }

    private static String written(List<? extends CodeLens> lenses) {
        return lenses.stream()
                .map(each -> EditorScript.written(each.getRange()) + " " + title(each) + "\n")
                .collect(Collectors.joining());
    }

    /** Follows the lenses of a line, and tells what is opened. */
    private String look(String path, Position position) throws IOException {
        StringBuilder seen = new StringBuilder();
        for (CodeLens lens : settled(path)) {
            if (isAt(lens, position) && !title(lens).equals(RUN)) {
                seen.append(opened(lens.getCommand()));
            }
        }
        return seen.toString();
    }

    private static boolean isAt(CodeLens lens, Position position) {
        return lens.getRange().getStart().getLine() == position.getLine();
    }

    /** Asks again, and tells what stands in the text at once, and what in the end. */
    private String runAgain(String path, Position position) {
        for (CodeLens lens : settled(path)) {
            if (isAt(lens, position) && title(lens).equals(RUN)) {
                var asked =
                        new ExecuteCommandParams(
                                lens.getCommand().getCommand(), lens.getCommand().getArguments());
                EditorClient.get(client.server().getWorkspaceService().executeCommand(asked));
            }
        }
        return written(lenses(path)) + written(settled(path));
    }

    private String opened(Command command) throws IOException {
        var asked = new ExecuteCommandParams(command.getCommand(), command.getArguments());
        try {
            client.server()
                    .getWorkspaceService()
                    .executeCommand(asked)
                    .get(PATIENCE.toSeconds(), TimeUnit.SECONDS);
        } catch (ExecutionException refused) {
            var error = (ResponseErrorException) refused.getCause();
            return "refused: " + error.getResponseError().getMessage() + "\n";
        } catch (InterruptedException | TimeoutException e) {
            throw new AssertionError(e);
        }
        Path shown = client.shown();
        return shown.getFileName() + ": " + beginning(Files.readString(shown)) + "\n";
    }

    private static String beginning(String text) {
        Matcher title = TITLE.matcher(text);
        return title.find() ? title.group(1) : text.lines().findFirst().orElse("");
    }
}
