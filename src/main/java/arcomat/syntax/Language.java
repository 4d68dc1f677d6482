package arcomat.syntax;

import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;
import arcomat.syntax.antlr.ArcomatParser;

import org.antlr.v4.runtime.ParserRuleContext;

/** The languages with their entry rules; the ending of a path tells which. */
enum Language {
    COMPONENT(".arc", "a component", "component Name { }"),
    AUTOMATON(".ioautomaton", "an automaton", "automaton Name { }"),
    CLASS_DIAGRAM(".cd", "a class diagram", "classdiagram Name { }"),
    STREAM_TEST(".mt", "a test suite", "testsuite Name for Component { }");

    private final String ending;

    /** What a file is about, with its article. */
    private final String definition;

    /** The shortest text of such a definition. */
    private final String example;

    Language(String ending, String definition, String example) {
        this.ending = ending;
        this.definition = definition;
        this.example = example;
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

    /** The number of the entry rule. */
    int rule() {
        return switch (this) {
            case COMPONENT -> ArcomatParser.RULE_arcUnit;
            case AUTOMATON -> ArcomatParser.RULE_automatonUnit;
            case CLASS_DIAGRAM -> ArcomatParser.RULE_classDiagramUnit;
            case STREAM_TEST -> ArcomatParser.RULE_testSuiteUnit;
        };
    }

    /**
     * The finding that a file of this language defines nothing.
     *
     * @param place where the definition is missed
     */
    Diagnostic nothingDefined(SourceFile file, int place) {
        return Diagnostic.error(
                Codes.EMPTY,
                file.span(place, place),
                "This file defines nothing. Write %s, such as '%s', or delete the file."
                        .formatted(definition, example));
    }
}
