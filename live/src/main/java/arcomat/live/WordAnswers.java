package arcomat.live;

import arcomat.editor.answer.completion.LineOffers;
import arcomat.editor.answer.completion.Offers;
import arcomat.editor.answer.completion.Proposal;
import arcomat.editor.answer.completion.Skeleton;
import arcomat.editor.answer.completion.WritingPlace;
import arcomat.editor.answer.fact.NameFacts;
import arcomat.editor.name.Mentions;
import arcomat.live.json.JsonText;
import arcomat.pipeline.beside.BesideText.Choice;
import arcomat.pipeline.recheck.ReadModels;
import arcomat.pipeline.world.WorldChoices;
import arcomat.source.SourceFile;
import arcomat.symbols.occurrences.Occurrence;
import arcomat.syntax.Caret;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;

/** What is said at a place of a text: what could be written there, and what a name means. */
final class WordAnswers {
    private WordAnswers() {}

    /** As the language server answers; nothing in comments and strings. */
    static String offers(ReadTexts texts, SourceFile file, int offset) {
        Optional<Caret> caret = Caret.at(file, offset);
        if (caret.isEmpty()) {
            return JsonText.object(json -> json.objects("names", List.of(), (each, none) -> {}));
        }
        Offers offers = Offers.at(file, WritingPlace.of(file, caret.get(), texts::draft));
        return JsonText.object(
                json -> {
                    json.field("from", caret.get().typed().start());
                    json.objects("names", offers.names(), WordAnswers::name);
                    json.strings("words", offers.words());
                    json.objects("pieces", offers.pieces(), WordAnswers::piece);
                });
    }

    /** The same in a world, whose programs are made of some models. */
    static String offers(SourceFile world, int offset, WorldChoices.Programs programs) {
        List<Choice> choices = new WorldChoices(world, programs).at(offset);
        LineOffers offers = LineOffers.at(world, offset, choices);
        List<Choice> names = choices.stream().filter(each -> !each.isWord()).toList();
        Stream<Choice> words = choices.stream().filter(Choice::isWord);
        return JsonText.object(
                json -> {
                    json.field("from", offers.typed().start());
                    json.objects("names", names, WordAnswers::choice);
                    json.strings("words", words.map(Choice::word).toList());
                    json.objects("pieces", offers.pieces(), WordAnswers::piece);
                });
    }

    private static void choice(JsonText json, Choice choice) {
        json.field("label", choice.word());
        json.field("kind", "name");
        json.field("detail", choice.what());
        json.objects("edits", List.of(), (each, none) -> {});
    }

    private static void name(JsonText json, Proposal name) {
        json.field("label", name.label());
        json.field("kind", name.kind().name().toLowerCase(Locale.ROOT));
        json.field("detail", name.detail());
        json.objects("edits", name.needed(), ModelAnswers::edit);
    }

    private static void piece(JsonText json, Skeleton piece) {
        json.field("label", piece.label());
        json.field("detail", piece.detail());
        json.field("text", piece.text());
    }

    /** As an editor shows it beside the name, in Markdown. */
    static String facts(ReadModels texts, String path, int offset) {
        Optional<Occurrence> named = Mentions.at(texts, path, offset);
        return JsonText.object(
                json ->
                        named.ifPresent(
                                name -> {
                                    ModelAnswers.place(json, name.span());
                                    json.field("text", NameFacts.of(texts, name));
                                }));
    }
}
