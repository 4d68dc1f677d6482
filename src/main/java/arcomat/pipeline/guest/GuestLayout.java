package arcomat.pipeline.guest;

import arcomat.check.guest.GuestThread;
import arcomat.guest.BehaviourLanguage.Written;
import arcomat.guest.host.Guests;
import arcomat.guest.host.Guests.Language;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;
import arcomat.source.Span;
import arcomat.syntax.Formatter;
import arcomat.syntax.Formatter.Formatted;
import arcomat.syntax.Parser;
import arcomat.syntax.WhiteSpace;
import arcomat.tree.Behaviour;
import arcomat.tree.Component;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeoutException;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/**
 * Canonical form, of texts in the languages of guests as well: what stands between their braces is
 * set by who knows the language. A guest may change white space and nothing else.
 */
public record GuestLayout(Guests guests) {
    /** ARC1204: a guest fails at a behaviour. */
    private static final String FAILED = "ARC1204";

    /** A behaviour is a page of text at most, and in an editor somebody waits for it. */
    private static final Duration LIMIT = Duration.ofSeconds(2);

    /** In front of what stands between braces. */
    private static final String STEP = "    ";

    /** A guest that cannot do what it is asked for. */
    private static final class NoLayout extends Exception {
        private static final long serialVersionUID = 1;

        NoLayout(String reason) {
            super(reason);
        }
    }

    /** A file with syntax errors is not formatted, nor one of which a guest cannot set its part. */
    public Formatted format(SourceFile file) {
        Formatted own = Formatter.format(file);
        return guests.languages().isEmpty() || own.text().isEmpty()
                ? own
                : withTheirs(file, own.text().get());
    }

    private Formatted withTheirs(SourceFile file, String formatted) {
        boolean isWindows = formatted.contains("\r\n");
        String text = isWindows ? formatted.replace("\r\n", "\n") : formatted;
        List<Behaviour.Foreign> all = behaviours(new SourceFile(file.path(), text));
        for (int i = all.size() - 1; i >= 0; i--) {
            try {
                text =
                        text.substring(0, all.get(i).body().start())
                                + body(all.get(i))
                                + text.substring(all.get(i).body().end());
            } catch (NoLayout e) {
                Span place = behaviours(file).get(i).keyword().span();
                return new Formatted(
                        Optional.empty(),
                        List.of(Diagnostic.error(FAILED, place, String.valueOf(e.getMessage()))));
            }
        }
        return new Formatted(Optional.of(isWindows ? text.replace("\n", "\r\n") : text), List.of());
    }

    /** In the order of the text. */
    private static List<Behaviour.Foreign> behaviours(SourceFile file) {
        List<Behaviour.Foreign> all = new ArrayList<>();
        Parser.parse(file)
                .unit()
                .filter(unit -> unit.definition() instanceof Component)
                .ifPresent(unit -> collect((Component) unit.definition(), all));
        return all;
    }

    private static void collect(Component component, List<Behaviour.Foreign> all) {
        component.elements().stream()
                .forEach(
                        element -> {
                            if (element instanceof Behaviour.Foreign foreign) {
                                all.add(foreign);
                            } else if (element instanceof Component inner) {
                                collect(inner, all);
                            }
                        });
    }

    /** What is to stand between the braces. */
    private String body(Behaviour.Foreign foreign) throws NoLayout {
        String written = foreign.body().text();
        Optional<Language> language = guests.language(foreign.keyword().text());
        Optional<String> layout =
                language.isPresent() ? layout(foreign, language.get()) : Optional.empty();
        if (layout.isEmpty()) {
            return written;
        }
        String set = layout.get().strip().isEmpty() ? "" : layout.get().stripTrailing();
        if (!WhiteSpace.isAllThatDiffers(new SourceFile("", written), new SourceFile("", set))) {
            throw failed(language.orElseThrow(), "it would change more than white space");
        }
        return between(set, indentation(foreign.span()));
    }

    private static Optional<String> layout(Behaviour.Foreign foreign, Language language)
            throws NoLayout {
        Written written = new Written(foreign.keyword().span(), foreign.name(), foreign.body());
        try {
            return new GuestThread(language.guest(), LIMIT)
                    .call(
                            () ->
                                    Objects.requireNonNull(
                                            language.translator().layout(written), "nothing"));
        } catch (ExecutionException e) {
            throw failed(language, String.valueOf(e.getCause()));
        } catch (TimeoutException e) {
            throw failed(language, "not done after " + LIMIT.toSeconds() + " s");
        }
    }

    private static NoLayout failed(Language language, String reason) {
        return new NoLayout(
                "guest '%s' could not lay this behaviour out: %s; tell who wrote it"
                        .formatted(language.guest(), reason));
    }

    /** One line stays beside the braces. */
    private static String between(String set, String indentation) {
        if (set.isEmpty()) {
            return "";
        }
        if (set.indexOf('\n') < 0) {
            return " " + set.strip() + " ";
        }
        Set<Integer> fixed = WhiteSpace.linesWithinComments(new SourceFile("", set));
        List<String> lines = set.lines().toList();
        return IntStream.range(0, lines.size())
                .mapToObj(i -> fixed.contains(i) ? lines.get(i) : moved(lines.get(i), indentation))
                .collect(Collectors.joining("\n", "\n", "\n" + indentation));
    }

    private static String moved(String line, String indentation) {
        return line.isBlank() ? "" : indentation + STEP + line.stripTrailing();
    }

    private static String indentation(Span behaviour) {
        String line = behaviour.file().line(behaviour.startPosition().line());
        return line.substring(0, line.length() - line.stripLeading().length());
    }
}
