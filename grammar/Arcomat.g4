/*
 * All languages in one parser. Each has an entry rule of its own: arcUnit, automatonUnit,
 * classDiagramUnit, testSuiteUnit. They share types and expressions, so they share one parser class.
 */
grammar Arcomat;

// Parse trees that take less memory; they mean the same.
options {
    superClass = arcomat.syntax.runtime.TreeParser;
    contextSuperClass = arcomat.syntax.runtime.RuleNode;
}

import Arc, ClassDiagram, StreamTest;
