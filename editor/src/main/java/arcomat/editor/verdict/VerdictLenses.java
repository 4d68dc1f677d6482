package arcomat.editor.verdict;

import arcomat.editor.desk.View;
import arcomat.editor.text.Positions;
import arcomat.pipeline.verdict.TextVerdict;
import arcomat.pipeline.verdict.TextVerdict.Tone;
import arcomat.pipeline.verdict.VerdictPlace;
import arcomat.pipeline.verdict.VerdictPlaces;

import org.eclipse.lsp4j.CodeLens;
import org.eclipse.lsp4j.Command;

import java.util.List;
import java.util.Optional;

/** Verdicts in the text, each above the line that it is about. */
public final class VerdictLenses {
    /** The command that shows all that there is to be said; with file, kind and name. */
    public static final String SHOW = "arcomat.show";

    /** The command that asks a test again, whatever is known; with the same words. */
    public static final String RUN = "arcomat.runTest";

    /** A lens that does nothing has a command without a name. */
    private static final String NOTHING = "";

    private final View view;
    private final Optional<Known> known;

    private VerdictLenses(View view, Optional<Known> known) {
        this.view = view;
        this.known = known;
    }

    /** For what is on the screen; what is not known is asked. */
    public static List<CodeLens> of(View view, Verdicts verdicts) {
        List<VerdictPlace> places = places(view);
        if (places.isEmpty()) {
            return List.of();
        }
        VerdictLenses lenses = new VerdictLenses(view, verdicts.look(view));
        return places.stream().flatMap(each -> lenses.at(each).stream()).toList();
    }

    private static List<VerdictPlace> places(View view) {
        return view.parsed().readable().map(VerdictPlaces::in).orElse(List.of());
    }

    /** What a lens stands for, if it is still about what is on the screen. */
    public static Optional<TextVerdict> shown(
            View view, Verdicts verdicts, String kind, String name) {
        return verdicts.look(view).filter(each -> each.holdsFor(view.models().edition())).stream()
                .flatMap(each -> each.verdicts().stream())
                .filter(each -> each.place().kind().name().equals(kind))
                .filter(each -> each.place().name().equals(name))
                .findFirst();
    }

    private List<CodeLens> at(VerdictPlace place) {
        return commands(place).stream()
                .map(each -> new CodeLens(Positions.range(place.span()), each, null))
                .toList();
    }

    private List<Command> commands(VerdictPlace place) {
        Optional<TextVerdict> verdict = known.flatMap(each -> each.at(place));
        if (known.filter(each -> each.holdsFor(view.models().edition())).isPresent()) {
            return verdict.map(this::current).orElse(List.of());
        }
        return verdict.map(each -> "was: " + each.text() + "; " + state("being asked again"))
                .or(() -> first(place))
                .map(text -> List.of(new Command(text, NOTHING)))
                .orElse(List.of());
    }

    /** A page of a test is worth a look whatever came of it: it begins where something differs. */
    private List<Command> current(TextVerdict verdict) {
        VerdictPlace place = verdict.place();
        Command said =
                command(
                        verdict.text() + (verdict.tone() == Tone.GOOD ? "" : ": show"),
                        SHOW,
                        place);
        return place.kind() == VerdictPlace.Kind.TEST
                ? List.of(said, command("run", RUN, place), command("debug", SHOW, place))
                : List.of(said);
    }

    private Command command(String title, String command, VerdictPlace place) {
        return new Command(
                title,
                command,
                List.of(view.address(view.file().path()), place.kind().name(), place.name()));
    }

    /** Whether somebody asks something of parts is not known before it was asked about. */
    private Optional<String> first(VerdictPlace place) {
        return switch (place.kind()) {
            case REQUIREMENT, INHERITED -> Optional.empty();
            default -> Optional.of(state("being asked"));
        };
    }

    private String state(String asked) {
        return known.filter(each -> each.edition() == view.models().edition())
                .flatMap(Known::obstacle)
                .orElse(asked);
    }
}
