// says: [cause]: SyntaxError: Expected property name or '}' in JSON at position 1
try { JSON.parse("{dog"); } catch (e) { throw new Error("cannot read the turn", {cause: e}); }
