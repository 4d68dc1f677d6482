package arcomat.editor.foreign;

import arcomat.check.guest.GuestThread;
import arcomat.editor.desk.View;
import arcomat.guest.BehaviourLanguage.Suggestion;
import arcomat.guest.BehaviourLanguage.Written;
import arcomat.guest.SituatedLanguage;
import arcomat.guest.Vicinity;
import arcomat.guest.host.Guests.Language;
import arcomat.source.Span;
import arcomat.syntax.Parser;
import arcomat.syntax.WrittenWords;
import arcomat.translate.VicinityView;
import arcomat.tree.Behaviour;
import arcomat.tree.Component;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeoutException;
import java.util.stream.Stream;

/** A behaviour in the language of a guest, as it stands in a file. */
public record GuestText(Language language, Behaviour.Foreign behaviour) {
    /** Who writes waits for it at every letter. */
    private static final Duration LIMIT = Duration.ofSeconds(2);

    /** Those of a file, in the order of the text; nothing is read where there are no guests. */
    public static List<GuestText> in(View view) {
        if (view.models().guests().languages().isEmpty()) {
            return List.of();
        }
        List<GuestText> texts = new ArrayList<>();
        Parser.parse(view.file())
                .readable()
                .filter(unit -> unit.definition() instanceof Component)
                .ifPresent(unit -> collect((Component) unit.definition(), view, texts));
        return texts;
    }

    private static void collect(Component component, View view, List<GuestText> texts) {
        for (Behaviour.Foreign each : component.elements(Behaviour.Foreign.class)) {
            view.models()
                    .guests()
                    .language(each.keyword().text())
                    .ifPresent(language -> texts.add(new GuestText(language, each)));
        }
        component.elements(Component.class).forEach(inner -> collect(inner, view, texts));
    }

    /** The one that somebody is writing in. */
    public static Optional<GuestText> around(View view, int offset) {
        return in(view).stream()
                .filter(each -> each.body().start() <= offset && offset <= each.body().end())
                .findFirst();
    }

    private Span body() {
        return behaviour.body();
    }

    /** Where words of the language stand; the keyword in front is one in any case. */
    public List<Span> words() {
        return Stream.concat(
                        Stream.of(behaviour.keyword().span()),
                        WrittenWords.in(body()).stream()
                                .filter(each -> language.words().containsKey(each.text())))
                .toList();
    }

    /** What could be written there; the words of the language where its guest fails. */
    public List<Suggestion> suggestions(View view, int offset) {
        Written written = new Written(behaviour.keyword().span(), behaviour.name(), body());
        int inside = offset - body().start();
        Callable<List<Suggestion>> question =
                language.translator() instanceof SituatedLanguage situated
                        ? situation(view)
                                .<Callable<List<Suggestion>>>map(
                                        around ->
                                                () -> situated.suggestions(written, around, inside))
                                .orElse(() -> situated.suggestions(written, inside))
                        : () -> language.translator().suggestions(written, inside);
        try {
            return new GuestThread(language.guest(), LIMIT)
                    .call(() -> List.copyOf(question.call()));
        } catch (ExecutionException | TimeoutException e) {
            return words(language);
        }
    }

    /** Of the component around it, as far as that can be read. */
    private Optional<Vicinity> situation(View view) {
        return view.models().workspace().components().stream()
                .filter(each -> each.node().span().isAround(behaviour.span()))
                .reduce((outer, inner) -> inner)
                .map(each -> VicinityView.of(each.signature()));
    }

    /** All that may stand in texts of a language. */
    public static List<Suggestion> words(Language language) {
        return language.words().entrySet().stream()
                .filter(each -> !each.getKey().equals(language.keyword()))
                .map(each -> new Suggestion(each.getKey(), each.getValue()))
                .toList();
    }
}
