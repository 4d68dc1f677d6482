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

    private UnitBuilder(SourceFile file, List<Comment> comments) {
        super(new Builders(file));
        this.comments = comments;
    }

    /**
     * @param context what an entry rule returned, without errors
     * @param comments every comment of the file in text order
     */
    public static Unit unit(SourceFile file, ParserRuleContext context, List<Comment> comments) {
        return new UnitBuilder(file, comments).build(context);
    }

    @Override
    public Unit visitArcUnit(ArcUnitContext context) {
        return context.component() == null
                ? unit(context.header(), builders.automata.automaton(context.automaton()))
                : unit(context.header(), builders.components.build(context.component()));
    }

    @Override
    public Unit visitAutomatonUnit(AutomatonUnitContext context) {
        return unit(context.header(), builders.automata.automaton(context.automaton()));
    }

    @Override
    public Unit visitClassDiagramUnit(ClassDiagramUnitContext context) {
        return unit(context.header(), builders.classDiagrams.classDiagram(context.classDiagram()));
    }

    @Override
    public Unit visitTestSuiteUnit(TestSuiteUnitContext context) {
        return unit(context.header(), builders.testSuites.testSuite(context.testSuite()));
    }

    private Unit unit(HeaderContext header, Definition definition) {
        List<Import> imports = new ArrayList<>();
        for (ImportDeclarationContext declaration : header.importDeclaration()) {
            imports.add(importOf(declaration));
        }
        return new Unit(
                builders.file.span(0, builders.file.text().length()),
                packageName(header.packageDeclaration()),
                imports,
                definition,
                comments);
    }

    private Optional<QualifiedName> packageName(PackageDeclarationContext context) {
        return context == null
                ? Optional.empty()
                : builders.qualifiedNames.buildOptional(context.qualifiedName());
    }

    private Import importOf(ImportDeclarationContext context) {
        QualifiedName name = builders.qualifiedNames.of(builders.names.buildAll(context.name()));
        return new Import(span(context), name, context.wildcard != null);
    }
}
