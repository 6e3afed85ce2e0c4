// says: Error: boom at the end
function deep(n){ if(n===0) throw new Error("boom at the end"); deep(n-1); }
deep(12);
