package arcomat.syntax.build;

import arcomat.source.SourceFile;
import arcomat.source.Span;
import arcomat.syntax.antlr.ArcomatParser;
import arcomat.tree.Definition;
import arcomat.tree.QualifiedName;
import arcomat.tree.Unit;
import arcomat.tree.Unit.Comment;
import arcomat.tree.Unit.Import;
import arcomat.tree.Unit.Spelling;

import org.antlr.v4.runtime.ParserRuleContext;
import org.antlr.v4.runtime.Token;

import java.util.List;
import java.util.function.UnaryOperator;

/** Whole files: the way into this package. */
public final class UnitBuilder extends TreeBuilder<Unit> {
    private final List<Comment> comments;
    private final List<Spelling> spellings;
    private final AutomatonBuilder automata;
    private final ComponentBuilder components;

    private UnitBuilder(
            Phrases phrases,
            List<Token> tokens,
            List<Comment> comments,
            List<Spelling> spellings,
            List<Span> gaps) {
        super(phrases);
        this.comments = comments;
        this.spellings = spellings;
        BlockBuilder blocks = new BlockBuilder(phrases);
        this.automata = new AutomatonBuilder(phrases, blocks);
        this.components = new ComponentBuilder(phrases, automata, tokens, gaps);
    }

    /**
     * @param context what an entry rule returned, without errors
     * @param tokens every token of the file, comments and its end included
     * @param comments every comment of the file in text order
     * @param gaps what has been taken out of the context, since it has errors
     * @param places where what stands in the file is said to stand
     */
    public static Unit unit(
            SourceFile file,
            ParserRuleContext context,
            List<Token> tokens,
            List<Comment> comments,
            List<Span> gaps,
            UnaryOperator<Span> places) {
        Phrases phrases = new Phrases(file, places);
        List<Spelling> spellings = Spellings.in(tokens, context, phrases);
        return new UnitBuilder(phrases, tokens, comments, spellings, gaps).build(context);
    }

    @Override
    public Unit visitArcUnit(ArcomatParser.ArcUnitContext context) {
        return context.component() == null
                ? unit(context.header(), automata.automaton(context.automaton()))
                : unit(context.header(), components.component(context.component()));
    }

    @Override
    public Unit visitAutomatonUnit(ArcomatParser.AutomatonUnitContext context) {
        return unit(context.header(), automata.automaton(context.automaton()));
    }

    @Override
    public Unit visitClassDiagramUnit(ArcomatParser.ClassDiagramUnitContext context) {
        return unit(
                context.header(),
                new ClassDiagramBuilder(phrases).classDiagram(context.classDiagram()));
    }

    @Override
    public Unit visitTestSuiteUnit(ArcomatParser.TestSuiteUnitContext context) {
        return unit(context.header(), new TestSuiteBuilder(phrases).testSuite(context.testSuite()));
    }

    private Unit unit(ArcomatParser.HeaderContext header, Definition definition) {
        return new Unit(
                phrases.wholeFile(),
                optional(
                        header.packageDeclaration(), p -> phrases.qualifiedName(p.qualifiedName())),
                each(header.importDeclaration(), this::importOf),
                definition,
                comments,
                spellings);
    }

    private Import importOf(ArcomatParser.ImportDeclarationContext context) {
        QualifiedName name = phrases.qualifiedName(phrases.names(context.name()));
        return new Import(span(context), name, context.wildcard != null);
    }
}
