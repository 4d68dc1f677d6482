# Models have the same lines on every machine.
*.arc text eol=lf
*.cd text eol=lf
*.mt text eol=lf
*.world text eol=lf
*.campaign text eol=lf
