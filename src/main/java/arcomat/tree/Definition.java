package arcomat.tree;

/** What a file is about. */
public sealed interface Definition extends Node
        permits Component, Automaton, ClassDiagram, TestSuite {}
