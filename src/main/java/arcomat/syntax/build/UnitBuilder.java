package arcomat.syntax.build;

import arcomat.source.SourceFile;
import arcomat.syntax.antlr.ArcomatParser.ArcUnitContext;
import arcomat.syntax.antlr.ArcomatParser.AutomatonUnitContext;
import arcomat.syntax.antlr.ArcomatParser.ClassDiagramUnitContext;
import arcomat.syntax.antlr.ArcomatParser.HeaderContext;
import arcomat.syntax.antlr.ArcomatParser.ImportDeclarationContext;
import arcomat.syntax.antlr.ArcomatParser.PackageDeclarationContext;
import arcomat.syntax.antlr.ArcomatParser.TestSuiteUnitContext;
import arcomat.tree.Comment;
import arcomat.tree.Definition;
import arcomat.tree.Import;
import arcomat.tree.QualifiedName;
import arcomat.tree.Unit;

import org.antlr.v4.runtime.ParserRuleContext;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Whole files: the way into this package. */
public final class UnitBuilder extends TreeBuilder<Unit> {
    private final List<Comment> comments;
    private final Phrases phrases;
    private final AutomatonBuilder automata;
    private final ComponentBuilder components;
    private final ClassDiagramBuilder classDiagrams;
    private final TestSuiteBuilder testSuites;

    private UnitBuilder(SharedTexts texts, List<Comment> comments) {
        super(texts);
        this.comments = comments;
        this.phrases = new Phrases(texts);
        this.automata = new AutomatonBuilder(phrases, new BlockBuilder(phrases));
        this.components = new ComponentBuilder(phrases, new BehaviourBuilder(phrases, automata));
        this.classDiagrams = new ClassDiagramBuilder(phrases);
        this.testSuites = new TestSuiteBuilder(phrases, new StreamBuilder(phrases));
    }

    /**
     * @param context what an entry rule returned, without errors
     * @param comments every comment of the file in text order
     */
    public static Unit unit(SourceFile file, ParserRuleContext context, List<Comment> comments) {
        return new UnitBuilder(new SharedTexts(file), comments).build(context);
    }

    @Override
    public Unit visitArcUnit(ArcUnitContext context) {
        return context.component() == null
                ? unit(context.header(), automata.automaton(context.automaton()))
                : unit(context.header(), components.build(context.component()));
    }

    @Override
    public Unit visitAutomatonUnit(AutomatonUnitContext context) {
        return unit(context.header(), automata.automaton(context.automaton()));
    }

    @Override
    public Unit visitClassDiagramUnit(ClassDiagramUnitContext context) {
        return unit(context.header(), classDiagrams.classDiagram(context.classDiagram()));
    }

    @Override
    public Unit visitTestSuiteUnit(TestSuiteUnitContext context) {
        return unit(context.header(), testSuites.testSuite(context.testSuite()));
    }

    private Unit unit(HeaderContext header, Definition definition) {
        List<Import> imports = new ArrayList<>();
        for (ImportDeclarationContext declaration : header.importDeclaration()) {
            imports.add(importOf(declaration));
        }
        return new Unit(
                texts.whole(),
                packageName(header.packageDeclaration()),
                imports,
                definition,
                comments);
    }

    private Optional<QualifiedName> packageName(PackageDeclarationContext context) {
        return context == null
                ? Optional.empty()
                : phrases.qualifiedNames.buildOptional(context.qualifiedName());
    }

    private Import importOf(ImportDeclarationContext context) {
        QualifiedName name = phrases.qualifiedNames.of(phrases.names.buildAll(context.name()));
        return new Import(span(context), name, context.wildcard != null);
    }
}
