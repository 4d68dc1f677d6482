package arcomat.translate;

import arcomat.guest.Meaning;
import arcomat.guest.SituatedLanguage;
import arcomat.source.Diagnostic;
import arcomat.symbols.signatures.BehaviourReader;
import arcomat.symbols.signatures.Signature;
import arcomat.syntax.Parser;
import arcomat.table.Tables;
import arcomat.tree.Behaviour;

import java.util.List;
import java.util.Optional;

/** The tool's own languages for behaviours besides automata. They need no limits. */
public final class HouseLanguages implements BehaviourReader {
    private static final List<SituatedLanguage> ALL = List.of(new Tables());

    private final LanguageTranslation.Parsing parsing;

    private HouseLanguages(LanguageTranslation.Parsing parsing) {
        this.parsing = parsing;
    }

    /** Knows those, and no guest's. */
    public static BehaviourReader reader() {
        return new HouseLanguages(Parser::parse);
    }

    /** The same on the caller's stack, for where there are no threads, as in a browser. */
    public static BehaviourReader readerHere() {
        return new HouseLanguages(Parser::parseHere);
    }

    /** Knows those, and what somebody else knows. */
    public static BehaviourReader and(BehaviourReader guests) {
        BehaviourReader own = reader();
        return (behaviour, around) ->
                own.read(behaviour, around).or(() -> guests.read(behaviour, around));
    }

    @Override
    public Optional<Reading> read(Behaviour.Foreign behaviour, Signature around) {
        return ALL.stream()
                .filter(each -> each.keyword().equals(behaviour.keyword().text()))
                .findFirst()
                .map(language -> read(behaviour, language, around));
    }

    private Reading read(Behaviour.Foreign behaviour, SituatedLanguage language, Signature around) {
        Meaning meaning = new Meaning();
        language.translate(
                LanguageTranslation.written(behaviour), VicinityView.of(around), meaning);
        LanguageTranslation translation = LanguageTranslation.of(behaviour, meaning);
        List<Problem> problems = meaning.problems().stream().map(HouseLanguages::told).toList();
        return translation
                .reading(parsing, problems)
                .orElseThrow(() -> new IllegalStateException(mistake(translation)));
    }

    /** Each problem of an own language has a code. */
    private static Problem told(Meaning.Problem each) {
        return new Problem(
                each.code().orElseThrow(),
                each.place(),
                each.message(),
                each.related(),
                each.fix());
    }

    private static String mistake(LanguageTranslation translation) {
        Diagnostic first = Parser.parseHere(translation.text().file()).findings().get(0);
        return first.message() + " in " + translation.text().file().text();
    }
}
