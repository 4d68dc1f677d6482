package arcomat.editor.foreign;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.check.LawBook;
import arcomat.editor.answer.completion.Completion;
import arcomat.editor.answer.fact.HoverCard;
import arcomat.editor.answer.shape.NameColours;
import arcomat.editor.desk.View;
import arcomat.editor.text.Positions;
import arcomat.guest.BehaviourLanguage;
import arcomat.guest.Meaning;
import arcomat.guest.SituatedLanguage;
import arcomat.guest.Vicinity;
import arcomat.guest.host.Guests;
import arcomat.pipeline.recheck.OpenModels;
import arcomat.source.SourceFile;

import org.eclipse.lsp4j.CompletionItem;
import org.eclipse.lsp4j.Position;
import org.eclipse.lsp4j.SemanticTokenTypes;
import org.junit.jupiter.api.Test;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/** What an editor shows of a text in a guest's language; a bar is where somebody writes. */
class GuestTextTest {
    private static final String LAMP =
            """
            package p;

            component Lamp {
                timing instant;
                port out Boolean lit;

                blink lit { /* on */ on 2, off on }
            }
            """;

    /** Knows what is said, and, if it is to, what may stand first. */
    private record Blinking(boolean isExact) implements BehaviourLanguage {
        @Override
        public String keyword() {
            return "blink";
        }

        @Override
        public Map<String, String> words() {
            return Map.of("blink", "goes on and off", "on", "is lit", "off", "is dark");
        }

        @Override
        public List<Suggestion> suggestions(Written behaviour, int offset) {
            if (isExact) {
                String before = behaviour.body().text().substring(0, offset);
                if (before.contains("throw")) {
                    throw new IllegalStateException(before);
                }
                return List.of(new Suggestion(before.isBlank() ? "first" : "later", "there"));
            }
            return BehaviourLanguage.super.suggestions(behaviour, offset);
        }

        @Override
        public void translate(Written behaviour, Meaning meaning) {
            meaning.problem(behaviour.keyword(), "never right");
        }
    }

    /** Offers the ports that are around. */
    private record Looking() implements SituatedLanguage {
        @Override
        public String keyword() {
            return "blink";
        }

        @Override
        public List<Suggestion> suggestions(Written behaviour, Vicinity around, int offset) {
            return around.of(Vicinity.Kind.OUTPUT).stream()
                    .map(each -> new Suggestion(each.name(), each.type().name()))
                    .toList();
        }

        @Override
        public void translate(Written behaviour, Vicinity around, Meaning meaning) {
            meaning.problem(behaviour.keyword(), "never right");
        }
    }

    private static View view(String text, boolean isExact) {
        return view(text, new Blinking(isExact));
    }

    private static View view(String text, BehaviourLanguage language) {
        Guests.Language known =
                new Guests.Language(
                        "lamps", "blink", List.of(), new TreeMap<>(language.words()), language);
        Guests guests =
                new Guests(
                        LawBook.OWN,
                        List.of(),
                        List.of(known),
                        List.of(),
                        List.of(),
                        List.of(),
                        List.of(),
                        List.of());
        SourceFile file = new SourceFile("p/Lamp.arc", text);
        OpenModels models =
                OpenModels.in(Path.of("models").toAbsolutePath(), false, guests)
                        .with(OpenModels.Edit.of(List.of(file)));
        return new View(
                models,
                file,
                models.parsed("p/Lamp.arc").orElseThrow(),
                path -> models.root().resolve(path));
    }

    private static List<String> offered(String text, boolean isExact) {
        return offered(text, new Blinking(isExact));
    }

    private static List<String> offered(String text, BehaviourLanguage language) {
        int bar = text.indexOf('|');
        View view = view(text.replace("|", ""), language);
        return Completion.at(view, bar).stream().map(CompletionItem::getLabel).sorted().toList();
    }

    private static String lamp(String body) {
        return "package p;\n\ncomponent Lamp {\n    port out Boolean lit;\n    " + body + "\n}\n";
    }

    @Test
    void wordsAreColouredAlsoWhereTheTextIsWrong() {
        View view = view(LAMP, false);
        List<Integer> data = NameColours.of(view).getData();
        int keyword = NameColours.LEGEND.getTokenTypes().indexOf(SemanticTokenTypes.Keyword);
        List<String> coloured = new ArrayList<>();
        int line = 0;
        int column = 0;
        for (int i = 0; i < data.size(); i += 5) {
            column = data.get(i) == 0 ? column + data.get(i + 1) : data.get(i + 1);
            line += data.get(i);
            if (data.get(i + 3) == keyword) {
                int start = view.offset(new Position(line, column));
                coloured.add(LAMP.substring(start, start + data.get(i + 2)));
            }
        }
        assertThat(coloured).containsExactly("blink", "on", "off", "on");
    }

    @Test
    void theKeywordIsOfferedWhereABehaviourMayStand() {
        assertThat(offered(lamp("b|"), false)).contains("blink", "automaton");
        assertThat(offered(lamp("port in |"), false)).doesNotContain("blink");
        assertThat(offered(lamp("automaton { | }"), false)).doesNotContain("blink");
    }

    @Test
    void insideTheTextOnlyTheGuestIsAsked() {
        assertThat(offered(lamp("blink lit { o| }"), false)).containsExactly("off", "on");
        assertThat(offered(lamp("blink lit { | }"), true)).containsExactly("first");
        assertThat(offered(lamp("blink lit { on 2, | }"), true)).containsExactly("later");
        assertThat(offered(lamp("blink lit { throw | }"), true)).containsExactly("off", "on");
    }

    /** Also while the rest of the file cannot be read. */
    @Test
    void aLanguageThatAsksForItKnowsWhatIsAround() {
        String text = lamp("blink lit { | }");
        assertThat(offered(text, new Looking())).containsExactly("lit");
        assertThat(offered(text.replace("blink", "connect ;\n blink"), new Looking()))
                .containsExactly("lit");
    }

    @Test
    void aWordSaysWhatItSays() {
        View view = view(LAMP, false);
        int off = LAMP.indexOf("off");
        Position place = Positions.position(view.file(), off + 1);
        assertThat(HoverCard.at(view, place))
                .hasValueSatisfying(
                        card ->
                                assertThat(card.getContents().getRight().getValue())
                                        .contains("off", "is dark"));
        Position comment = Positions.position(view.file(), LAMP.indexOf("/* on") + 4);
        assertThat(HoverCard.at(view, comment)).isEmpty();
    }
}
