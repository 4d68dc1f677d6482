package arcomat.syntax;

import arcomat.source.SourceFile;
import arcomat.syntax.antlr.ArcomatParser;

import org.antlr.v4.runtime.ParserRuleContext;

/** The languages with their entry rules; the ending of a path tells which. */
enum Language {
    COMPONENT(".arc", "a component"),
    AUTOMATON(".ioautomaton", "an automaton"),
    CLASS_DIAGRAM(".cd", "a class diagram"),
    STREAM_TEST(".mt", "a test suite");

    private final String ending;
    private final String definition;

    Language(String ending, String definition) {
        this.ending = ending;
        this.definition = definition;
    }

    /** What a file of this language is about, with its article. */
    String definition() {
        return definition;
    }

    static Language of(SourceFile file) {
        for (Language language : values()) {
            if (file.path().endsWith(language.ending)) {
                return language;
            }
        }
        return COMPONENT;
    }

    ParserRuleContext enter(ArcomatParser parser) {
        return switch (this) {
            case COMPONENT -> parser.arcUnit();
            case AUTOMATON -> parser.automatonUnit();
            case CLASS_DIAGRAM -> parser.classDiagramUnit();
            case STREAM_TEST -> parser.testSuiteUnit();
        };
    }
}
