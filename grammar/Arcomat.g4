/*
 * All languages in one parser. Each has an entry rule of its own: arcUnit, automatonUnit,
 * classDiagramUnit, testSuiteUnit. They share types and expressions, so they share one parser class.
 */
grammar Arcomat;

import Arc, ClassDiagram, StreamTest;
